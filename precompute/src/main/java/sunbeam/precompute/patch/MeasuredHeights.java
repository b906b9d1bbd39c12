package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.COLUMNS;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.Samples;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.format.ScanFormats;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Quoted;

/**
 * Heights of a file before any preparation.
 *
 * @param map heights in meters; missing samples are NaN
 * @param channels one line per channel of the file: number, name, samples and unit
 * @param notes choices that the program made, one line each
 */
record MeasuredHeights(HeightMap map, String source, List<String> channels, List<String> notes) {
    /**
     * Reads the heights of a file with its scale, completed by the user's choices. A scale is never guessed.
     *
     * @throws PatchException if the file cannot be used
     * @throws SettingException if a choice contradicts the file, is absurd or is missing
     */
    static MeasuredHeights read(Path file, Choices choices) {
        requireReadable(file);
        try (ScanBytes bytes = ScanBytes.open(file)) {
            ScanReader reader = ScanFormats.find(bytes, choices.find(PatchSettings.DECIMAL_MARK))
                    .orElseThrow(
                            () -> new ScanException(
                                    bytes.size() == 0
                                            ? "is empty; copy or export it again"
                                            : "is neither an image nor a scan in a format that Sunbeam knows; open it with"
                                                    + " Gwyddion, which reads 170 others, and export it as .gwy, .gsf or text"));
            return of(file, reader, reader.open(bytes), choices);
        } catch (ScanException unusable) {
            throw new PatchException(file + " " + unusable.getMessage(), unusable);
        } catch (IOException failure) {
            throw new PatchException(file + " cannot be read (" + failure.getMessage() + "); check the file", failure);
        }
    }

    /** Reading a device or a pipe might never end. */
    static void requireReadable(Path file) {
        if (!Files.exists(file)) {
            throw new PatchException(file + ": no such file; check the name and the folder");
        }
        if (Files.isDirectory(file)) {
            throw new PatchException(file + " is a folder; name the image, scan or descriptor (.json) in it");
        }
        if (!Files.isRegularFile(file)) {
            throw new PatchException(file + " is no regular file; copy the image, scan or descriptor to one");
        }
        if (!Files.isReadable(file)) {
            throw new PatchException(file + " cannot be read; check its permissions");
        }
    }

    private static MeasuredHeights of(Path file, ScanReader reader, ChannelList channels, Choices choices)
            throws IOException {
        int index = choices.find(CHANNEL)
                .map(wanted -> chosen(file, channels, wanted))
                .or(channels::heights)
                .orElseThrow(() -> noHeights(file, channels));
        ScanChannel channel = inColumns(file, channels.channels().get(index), ScanFormats.isPicture(reader), choices);
        FileScale scale = FileScale.of(file, channel, choices);
        HeightMap map = new HeightMap(
                channel.columns(),
                channel.rows(),
                scale.pitchX(),
                scale.pitchY(),
                channel.samples().scale(scale.metersPerUnit(), 0).read());
        Plausibility.requireRelief(map, scale.heightsFrom(), file);
        String label = channels.label(index);
        String which = channels.count() == 1 && channel.name().isEmpty() ? "" : ", channel " + label;
        String source = file.getFileName() + " (" + reader.format() + which + "), " + map.describe();
        boolean several = !choices.has(CHANNEL) && channels.candidates() > 1;
        List<String> notes =
                several ? List.of("heights from channel " + label + "; the file has " + channels.names()) : List.of();
        return new MeasuredHeights(map, source, channels.lines(), notes);
    }

    private static int chosen(Path file, ChannelList channels, String wanted) {
        int index = channels.find(wanted)
                .orElseThrow(() -> new SettingException(
                        CHANNEL,
                        "is no channel of " + file + ", which has " + channels.names()
                                + channels.nearest(wanted)
                                        .map(name -> " (did you mean " + Quoted.of(name) + "?)")
                                        .orElse("")));
        ScanChannel channel = channels.channels().get(index);
        if (!channel.maybeHeights()) {
            throw new SettingException(
                    CHANNEL,
                    "holds no heights: " + file + " gives it in " + Quoted.of(channel.unit()) + ", no unit of length");
        }
        return index;
    }

    private static RuntimeException noHeights(Path file, ChannelList channels) {
        return channels.channels().stream().noneMatch(ScanChannel::maybeHeights)
                ? new PatchException(file + " holds no heights: none of its channels has a unit of length ("
                        + String.join("; ", channels.lines().subList(0, Math.min(3, channels.count())))
                        + "); export the height")
                : new SettingException(
                        CHANNEL,
                        "is missing: none of the channels of " + file + " is known to hold heights; choose one of "
                                + channels.names() + " (no channel of a picture in false colors is one)");
    }

    /** Splits a file's single row or column of numbers into rows of the chosen length. */
    private static ScanChannel inColumns(Path file, ScanChannel channel, boolean picture, Choices choices) {
        Optional<Integer> columns = choices.find(COLUMNS);
        Samples samples = channel.samples();
        boolean inRows = samples.rows() > 1 && samples.columns() > 1;
        if (picture && columns.isPresent()) {
            throw new SettingException(
                    COLUMNS, "is for numbers without rows, but " + file + " is an image; leave it out");
        }
        if (columns.isEmpty()) {
            boolean line = !picture && !inRows && channel.extent().width().isEmpty() && samples.count() > 2;
            if (line && !choices.has(PatchSettings.HEIGHT)) {
                throw new SettingException(
                        COLUMNS,
                        "is missing: " + file + " has its " + samples.count()
                                + " numbers in one row or column; say how many make a row");
            }
            return channel;
        }
        if (inRows && columns.get() != samples.columns()) {
            throw new SettingException(
                    COLUMNS, "contradicts " + file + ", whose rows have " + samples.columns() + "; leave it out");
        }
        if (samples.count() % columns.get() != 0) {
            throw new SettingException(COLUMNS, "does not divide the " + samples.count() + " numbers of " + file);
        }
        return channel.reshape(columns.get(), (int) (samples.count() / columns.get()));
    }
}
