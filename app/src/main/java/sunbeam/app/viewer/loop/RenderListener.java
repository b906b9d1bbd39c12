package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import jrtr.ContextInfo;

/** Hears from the render thread what it has done. The images are not touched again. */
public interface RenderListener {

    /** OpenGL works. */
    void opened(ContextInfo info);

    /** Nothing more will be drawn, and why, in one line. */
    void failed(String message);

    /** Something could not be drawn, and why, in one line; what is on screen stays, and drawing goes on. */
    void refused(String message);

    /** A picture of a state that is not final. */
    void preview(ViewState state, Stage.Preview preview);

    /** The final picture of a state, and the nanoseconds that it took. */
    void complete(ViewState state, Stage.Final picture, long nanoseconds);

    /** The final picture waits for tiles that are being baked, of which so large a share is there. */
    void waiting(double share);

    /** A part of the final picture of a state. */
    void tile(ViewState state, BufferedImage image, int x, int y, double shareDone);

    /** A BRDF map. */
    void map(ViewState state, BufferedImage image, boolean isFinal);
}
