package sunbeam.app.accuracy;

/** Varies one quantity and measures what it does to the error. */
interface Experiment {

    /** The errors of one patch. */
    ErrorFigure run(Subject subject);
}
