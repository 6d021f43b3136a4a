/** Words of the tour. */
export const tourEn = {
  tour: {
    title: 'Tour: the pathfinder of figure 6',
    intro:
      'One acting module, its request given by the goal App, feedback from the robot, one command. Build it, then run it.',
    show: 'Do it for me',
    progress: (at: number, of: number) => `Step ${at} of ${of}:`,
    finish: 'End the tour',
    ended:
      'The goal is reached: this is figure 6. Save it, change it, run it with another seed, or look at the report.',
    steps: {
      file: 'Start a new controller for the pathfinder robot (File, New controller).',
      sensations: 'Add the sensations: the goal, its direction, the position, the heading and the contact.',
      cell: 'Add the sensing module GridCell and connect the position to it.',
      app: 'Add the goal App and connect the sensation of the goal to its request: the application is the trainer.',
      router: 'Add the acting module DynamicMapRouter (AmDmr).',
      wires: 'Connect goal, cell, position, heading, contact and goal_direction of the router.',
      command: 'Let the router drive the command step: eight directions, the amplitudes of the paper.',
      run: 'Configure the experiment, then Run: watch the map grow until the goal is reached.',
    },
  },
};

export const tourEs: typeof tourEn = {
  tour: {
    title: 'Guía: el buscador de rutas de la figura 6',
    intro:
      'Un módulo de actuación, su solicitud dada por el objetivo App, retroalimentación del robot, un mando. Constrúyalo y ejecútelo.',
    show: 'Hágalo por mí',
    progress: (at: number, of: number) => `Paso ${at} de ${of}:`,
    finish: 'Terminar la guía',
    ended: 'Objetivo alcanzado: esta es la figura 6. Guárdela, cámbiela, ejecútela con otra semilla o vea el informe.',
    steps: {
      file: 'Empiece un controlador nuevo para el robot del buscador de rutas (Archivo, Nuevo controlador).',
      sensations: 'Añada las sensaciones: el objetivo, su dirección, la posición, el rumbo y el contacto.',
      cell: 'Añada el módulo de detección GridCell y conéctele la posición.',
      app: 'Añada el objetivo App y conecte la sensación del objetivo a su solicitud: la aplicación es el entrenador.',
      router: 'Añada el módulo de actuación DynamicMapRouter (AmDmr).',
      wires: 'Conecte goal, cell, position, heading, contact y goal_direction del módulo.',
      command: 'Haga que el módulo conduzca el mando step: ocho direcciones, las amplitudes del artículo.',
      run: 'Configure el experimento y ejecute: vea crecer el mapa hasta alcanzar el objetivo.',
    },
  },
};
