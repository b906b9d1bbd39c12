package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import jrtr.ContextInfo;

/** Hears from the render thread what it has done. The images are not touched again. */
public interface RenderListener {

    void opened(ContextInfo info);

    /** Nothing more will be drawn, and why, in one line. */
    void failed(String message);

    /** Something could not be drawn, and why, in one line; what is on screen stays, and drawing goes on. */
    void refused(String message);

    void preview(ViewState state, Stage.Preview preview);

    void complete(ViewState state, Stage.Final picture, long nanoseconds);

    /** The final picture waits for tiles that are being baked, of which so large a share is there. */
    void waiting(double share);

    void tile(ViewState state, BufferedImage image, int x, int y, double shareDone);

    void map(ViewState state, BufferedImage image, boolean isFinal);
}
