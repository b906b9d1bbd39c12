package sunbeam.app.viewer.window;

import java.awt.image.BufferedImage;
import java.util.Optional;
import javax.swing.SwingUtilities;
import sunbeam.app.viewer.loop.RenderLoop;
import sunbeam.app.viewer.picture.PictureView;

/** Shows over the final picture how the nanostructure lies, while that is asked for. */
final class StrokesPresenter {
    private final PictureView picture;
    private final RenderLoop loop;
    private boolean shown;
    // Of the strokes that are being drawn; older ones are not shown.
    private long newest;

    StrokesPresenter(PictureView picture, RenderLoop loop) {
        this.picture = picture;
        this.loop = loop;
    }

    void toggle(boolean isFinal) {
        shown = !shown;
        outdated();
        if (isFinal) {
            follow();
        }
    }

    /** They are not those of the newest state. */
    void outdated() {
        newest++;
        picture.showStrokes(Optional.empty());
    }

    /** The picture of the newest state is final. */
    void follow() {
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
