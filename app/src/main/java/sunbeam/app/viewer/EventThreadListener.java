package sunbeam.app.viewer;

import java.awt.image.BufferedImage;
import javax.swing.SwingUtilities;
import jrtr.ContextInfo;

/** Takes what the render thread has to say to the event thread. */
record EventThreadListener(RenderListener there) implements RenderListener {
    @Override
    public void opened(ContextInfo info) {
        SwingUtilities.invokeLater(() -> there.opened(info));
    }

    @Override
    public void failed(String message) {
        SwingUtilities.invokeLater(() -> there.failed(message));
    }

    @Override
    public void refused(String message) {
        SwingUtilities.invokeLater(() -> there.refused(message));
    }

    @Override
    public void preview(
            ViewState state, BufferedImage image, int divisor, boolean tables, double exposure, long nanoseconds) {
        SwingUtilities.invokeLater(() -> there.preview(state, image, divisor, tables, exposure, nanoseconds));
    }

    @Override
    public void waiting(double share) {
        SwingUtilities.invokeLater(() -> there.waiting(share));
    }

    @Override
    public void complete(ViewState state, BufferedImage image, double exposure, long nanoseconds) {
        SwingUtilities.invokeLater(() -> there.complete(state, image, exposure, nanoseconds));
    }

    @Override
    public void tile(ViewState state, BufferedImage image, int x, int y, double shareDone) {
        SwingUtilities.invokeLater(() -> there.tile(state, image, x, y, shareDone));
    }

    @Override
    public void map(ViewState state, BufferedImage image, boolean isFinal) {
        SwingUtilities.invokeLater(() -> there.map(state, image, isFinal));
    }
}
