package sunbeam.app.measure.accuracy;

/** Varies one quantity and measures what it does to the error. */
interface Experiment {

    /** The errors of one patch. */
    Figure run(Subject subject);

    /** About how long it takes, in units of the time of one exact colour. */
    int cost();
}
