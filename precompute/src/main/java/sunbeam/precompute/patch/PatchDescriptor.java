package sunbeam.precompute.patch;

import java.nio.file.Path;
import sunbeam.precompute.setting.Choices;

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
 * @param choices of {@link PatchSettings#OF_FILES}; width and maxHeight are there
 * @param note remark for people, empty without one
 */
record PatchDescriptor(Path file, Path heights, Choices choices, String note) {}
