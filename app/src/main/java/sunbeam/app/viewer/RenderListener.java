package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import jrtr.ContextInfo;

/** Hears from the render thread what it has done. The images are not touched again. */
interface RenderListener {

    /** OpenGL works. */
    void opened(ContextInfo info);

    /** Nothing more will be drawn, and why, in one line. */
    void failed(String message);

    /** Something could not be drawn, and why, in one line; what is on screen stays, and drawing goes on. */
    void refused(String message);

    /**
     * A whole picture, which may have fewer pixels than the window.
     *
     * @param state what it shows
     * @param divisor it has a divisor-th of the columns and rows, or of the samples of diffracted light along them
     * @param hasColors whether it shows diffracted light, not the body alone
     * @param exposure factor that was applied
     */
    void preview(ViewState state, BufferedImage image, int divisor, boolean hasColors, double exposure);

    /**
     * The whole picture as {@code render} writes it.
     *
     * @param state what it shows
     * @param exposure factor that was applied
     * @param nanoseconds that it took
     */
    void complete(ViewState state, BufferedImage image, double exposure, long nanoseconds);

    /** The final picture waits for tiles that are being baked, of which so large a share is there. */
    void waiting(double share);

    /** A part of the final picture. */
    void tile(BufferedImage image, int x, int y, double shareDone);

    /** A BRDF map. */
    void map(ViewState state, BufferedImage image, boolean isFinal);
}
