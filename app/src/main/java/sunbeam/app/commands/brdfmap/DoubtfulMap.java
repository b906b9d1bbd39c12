package sunbeam.app.commands.brdfmap;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.util.List;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.patch.Patch;

/** Maps that can only be a mistake: of a mirror, or black all over. They are written, and said to be doubtful. */
final class DoubtfulMap {
    // A smaller map may pass between a grating's orders.
    private static final int FEWEST_PIXELS = 32;

    private DoubtfulMap() {}

    /**
     * Warns where a map is doubtful.
     *
     * @param patches of the maps; that one is flat has been said when it was loaded
     * @param drawn the maps as they are shown
     * @return what the process ends with if nothing worse has happened
     */
    static ExitCode judge(List<Patch> patches, List<BufferedImage> drawn, PrintWriter err) {
        boolean black = drawn.stream().anyMatch(DoubtfulMap::isBlack);
        if (black) {
            err.println(Messages.warning("the map is black all over; let the exposure be automatic, or raise it"));
            err.flush();
        }
        boolean mirror = patches.stream().anyMatch(patch -> patch.heights().relief() == 0);
        return black || mirror ? ExitCode.TOLERANCE_MISSED : ExitCode.OK;
    }

    private static boolean isBlack(BufferedImage image) {
        if (image.getWidth() < FEWEST_PIXELS) {
            return false;
        }
        for (int y = 0; y < image.getHeight(); y++) {
            for (int x = 0; x < image.getWidth(); x++) {
                if ((image.getRGB(x, y) & 0xffffff) != 0) {
                    return false;
                }
            }
        }
        return true;
    }
}
