package sunbeam.app.gpu.picture;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.util.List;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.patch.Patch;

/** Results that can only be a mistake: of a mirror, or black all over. They are written, and said to be doubtful. */
public final class DoubtfulPicture {
    // A smaller picture may pass between a grating's orders.
    private static final int FEWEST_PIXELS = 32;

    private DoubtfulPicture() {}

    /** What the process ends with if nothing worse has happened; that a patch is a mirror was said when it was loaded. */
    public static ExitCode ofPatches(List<Patch> patches) {
        return patches.stream().anyMatch(Patch::isMirror) ? ExitCode.TOLERANCE_MISSED : ExitCode.OK;
    }

    /**
     * Warns where something drawn is black.
     *
     * @param patches that were drawn
     * @param black whether what was drawn is black all over
     * @param what was drawn, for people: "the map"
     * @param automatic whether its exposure was found from it
     * @return what the process ends with if nothing worse has happened
     */
    public static ExitCode judge(List<Patch> patches, boolean black, String what, boolean automatic, PrintWriter err) {
        if (!black) {
            return ofPatches(patches);
        }
        String remedy = automatic
                ? ", though its exposure was found from it: no light goes where it looks; move the light"
                : "; let the exposure be automatic, or raise it";
        err.println(Messages.warning(what + " is black all over" + remedy));
        return ExitCode.TOLERANCE_MISSED;
    }

    /** Whether no pixel is other than black; never of pictures so small that chance may make them so. */
    public static boolean isBlack(BufferedImage image) {
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
