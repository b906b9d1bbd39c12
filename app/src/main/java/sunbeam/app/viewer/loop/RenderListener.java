package sunbeam.app.viewer.loop;

import java.awt.image.BufferedImage;
import jrtr.ContextInfo;

/** Listener of the render thread. Images passed to it do not change afterwards. */
public interface RenderListener {

    void opened(ContextInfo info);

    /** Reports, in one line, why drawing has ended for good. */
    void failed(String message);

    /** Reports, in one line, why a state could not be drawn; the picture on screen stays, and drawing continues. */
    void refused(String message);

    /** Shows the first scene's body, before its patches and method are loaded. */
    void body(BufferedImage image);

    void preview(ViewState state, Stage.Preview preview);

    void complete(ViewState state, Stage.Final picture, long nanoseconds);

    /** Reports the resident share of the final picture's tiles, 0 to 1, while the picture waits for the rest. */
    void waiting(double share);

    void tile(ViewState state, BufferedImage image, int x, int y, double shareDone);

    void map(ViewState state, BufferedImage image, boolean isFinal);
}
