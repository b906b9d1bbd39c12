package sunbeam.app.gpu.picture;

import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import sunbeam.app.terminal.ExitCode;
import sunbeam.app.terminal.Messages;
import sunbeam.precompute.patch.Patch;

/** Warns about pictures that are probably a mistake: of a mirror, or all black. They are written nevertheless. */
public final class DoubtfulPicture {
    // A smaller picture may lie between a grating's orders.
    private static final int FEWEST_PIXELS = 32;

    private DoubtfulPicture() {}

    /** Returns the exit code unless something else fails. Loading a patch already warns if it is a mirror. */
    public static ExitCode ofPatches(List<Patch> patches) {
        return patches.stream().anyMatch(Patch::isMirror) ? ExitCode.TOLERANCE_MISSED : ExitCode.OK;
    }

    /** Warns if a picture, named such as "the map", is black; returns the exit code unless something else fails. */
    public static ExitCode judge(
            List<Patch> patches, boolean black, String picture, boolean automatic, PrintWriter err) {
        if (!black) {
            return ofPatches(patches);
        }
        String remedy = automatic
                ? ", though its exposure was found from it: no light goes where it looks; move the light"
                : "; let the exposure be automatic, or raise it";
        err.println(Messages.warning(picture + " is black all over" + remedy));
        return ExitCode.TOLERANCE_MISSED;
    }

    /** True if all pixels are black; false for small pictures, which may be black by chance. */
    public static boolean isBlack(BufferedImage image) {
        int width = image.getWidth();
        return width >= FEWEST_PIXELS
                && IntStream.range(0, image.getHeight())
                        .mapToObj(y -> image.getRGB(0, y, width, 1, null, 0, width))
                        .flatMapToInt(Arrays::stream)
                        .allMatch(color -> (color & 0xffffff) == 0);
    }
}
