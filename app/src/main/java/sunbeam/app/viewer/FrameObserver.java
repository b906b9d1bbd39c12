package sunbeam.app.viewer;

/** Told on the event thread what is asked for and what has come on screen; for measuring. */
interface FrameObserver {
    /** Nobody watches. */
    FrameObserver NONE = new FrameObserver() {};

    /** A state is wanted on screen. */
    default void asked(ViewState state) {}

    /**
     * A state has been painted as a preview.
     *
     * @param divisor the preview has a divisor-th of the columns and rows
     */
    default void shown(ViewState state, int divisor) {}
}
