package sunbeam.precompute.patch;

import java.nio.file.Path;
import java.util.Optional;

/**
 * A patch described by a JSON file beside its image:
 *
 * <pre>{@code
 * {
 *   "heights":   "elaphe.png",   image in the descriptor's folder or below it; required
 *   "width":     "65 um",        extent along x; required
 *   "height":    "65 um",        extent along y; square pixels without it
 *   "maxHeight": "375 nm",       height of full scale: of 255 of 8 bits, 65535 of 16 bits, 1.0 of float; required
 *   "channel":   "red",          grey, red, green, blue or alpha; needed where red, green and blue differ
 *   "levelling": "plane",        none, mean (default) or plane
 *   "note":      "shed skin"     for people
 * }
 * }</pre>
 *
 * <p>A float image that holds metres has the maxHeight "1 m", one that holds nanometres "1 nm".
 *
 * @param file the descriptor itself
 * @param heights the image, resolved against the descriptor's folder and inside it
 * @param scale width, extent along y and height of full scale
 * @param channel the channel that holds the heights, where the descriptor says so
 * @param levelling what to subtract, where the descriptor says so
 * @param note remark for people, empty without one
 */
record PatchDescriptor(
        Path file,
        Path heights,
        PatchScale scale,
        Optional<Channel> channel,
        Optional<Levelling> levelling,
        String note) {}
