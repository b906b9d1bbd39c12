package sunbeam.precompute.patch;

import java.util.List;

/**
 * What a file holds, before anything is done to it.
 *
 * @param map heights in metres; missing samples are NaN
 * @param source the file and how it was read, for people
 * @param channels a line for each channel of a scan, with its number, name and unit; empty for images
 * @param notes what was chosen for the user, one line each
 * @param warnings what is possible but unlikely about the scale, one line each
 */
record MeasuredHeights(
        HeightMap map, String source, List<String> channels, List<String> notes, List<String> warnings) {}
