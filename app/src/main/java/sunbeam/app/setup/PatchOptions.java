package sunbeam.app.setup;

import picocli.CommandLine.Option;
import sunbeam.precompute.patch.Patch;
import sunbeam.precompute.patch.PatchLoader;
import sunbeam.precompute.patch.PatchRequest;
import sunbeam.precompute.patch.builtin.BuiltInPatches;

/** Which surface; to be used as a picocli mixin. */
public final class PatchOptions {
    @Option(
            names = "--patch",
            paramLabel = "PATCH",
            defaultValue = "elaphe-like",
            description = "The surface: a built-in patch (blaze, sinusoid, lamellar, disc, elaphe-like,"
                    + " xenopeltis-like), a descriptor (.json), or an image (PNG, TIFF, BMP) with --width and"
                    + " --max-height. Default: ${DEFAULT-VALUE}.")
    private String patch;

    @Option(names = "--width", paramLabel = "LENGTH", description = "Extent of an image along x, for example 65um.")
    private String width;

    @Option(
            names = "--height",
            paramLabel = "LENGTH",
            description = "Extent of an image along y. Default: square pixels.")
    private String height;

    @Option(
            names = "--max-height",
            paramLabel = "LENGTH",
            description = "Height of an image's full scale (255, 65535, or 1.0), for example 375nm.")
    private String maxHeight;

    @Option(
            names = "--channel",
            paramLabel = "CHANNEL",
            description = "Channel of an image that holds the heights: grey, red, green, blue, alpha.")
    private String channel;

    @Option(
            names = "--level",
            paramLabel = "KIND",
            description = "What is subtracted from the heights: none, mean (default), plane.")
    private String level;

    /** Loads the patch; nothing else is read before it is known to be usable. */
    public Patch load() {
        return load(patch);
    }

    /** As {@link #load()}, with a patch named elsewhere than by the option. */
    public Patch load(String named) {
        return load(PatchRequest.parse(named, width, height, maxHeight, channel, level));
    }

    /** Loads a patch that is asked for elsewhere; built-in names are known. */
    public static Patch load(PatchRequest request) {
        return new PatchLoader(BuiltInPatches.names(), BuiltInPatches::generate).load(request);
    }
}
