package sunbeam.app.viewer.window;

import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.swing.SwingUtilities;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.picture.PictureView;

/** Presenter of the strokes that show the nanostructure's orientation over the final picture. */
final class StrokesPresenter {
    private final PictureView picture;
    private final RenderLoop loop;
    private boolean shown;
    // Number of the newest request; results of older requests are discarded.
    private long newest;

    StrokesPresenter(PictureView picture, RenderLoop loop) {
        this.picture = picture;
        this.loop = loop;
    }

    boolean areShown() {
        return shown;
    }

    void toggle(boolean isFinal) {
        shown = !shown;
        outdated();
        if (isFinal) {
            request();
        }
    }

    void outdated() {
        newest++;
        picture.showStrokes(Optional.empty());
    }

    void request() {
        if (!shown) {
            return;
        }
        long number = ++newest;
        int width = picture.pictureWidth();
        int height = picture.pictureHeight();
        loop.submit(stage -> {
            BufferedImage strokes = stage.strokes(width, height);
            SwingUtilities.invokeLater(() -> {
                if (number == newest) {
                    picture.showStrokes(Optional.of(strokes));
                }
            });
        });
    }
}
