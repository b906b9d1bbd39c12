package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.scan.ChannelList;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.format.ScanFormats;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;

/**
 * What a file holds, before anything is done to it.
 *
 * @param map heights in metres; missing samples are NaN
 * @param source the file and how it was read, for people
 * @param channels a line for each channel of a file, with its number, name and unit
 * @param notes what was chosen for the user, one line each
 */
record MeasuredHeights(HeightMap map, String source, List<String> channels, List<String> notes) {
    /**
     * The heights of a file: its own scale, completed by what was chosen. Neither is ever guessed.
     *
     * @param choices of {@link PatchSettings#OF_FILES}
     * @throws PatchException when the file cannot be used
     * @throws SettingException when what was chosen contradicts it or is absurd, or something must be chosen
     */
    static MeasuredHeights read(Path file, Choices choices) {
        InputFiles.requireReadable(file);
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
            throw new PatchException(
                    String.format(Locale.ROOT, "%s cannot be read (%s); check the file", file, failure.getMessage()),
                    failure);
        }
    }

    private static MeasuredHeights of(Path file, ScanReader reader, ChannelList channels, Choices choices)
            throws IOException {
        ChosenChannel chosen = ChosenChannel.of(file, channels, ScanFormats.isPicture(reader), choices);
        FileScale scale = FileScale.of(file, chosen.channel(), choices);
        ScanChannel channel = chosen.channel();
        double[] heights = channel.samples().scaled(scale.metresPerUnit(), 0).read();
        HeightMap map = HeightMap.owning(channel.columns(), channel.rows(), scale.pitchX(), scale.pitchY(), heights);
        Plausibility.requireRelief(map, scale.heightsFrom(), file);
        String which = channels.count() == 1 && channel.name().isEmpty() ? "" : ", channel " + chosen.label();
        String source =
                String.format(Locale.ROOT, "%s (%s%s), %s", file.getFileName(), reader.format(), which, map.describe());
        boolean choice = !choices.has(PatchSettings.CHANNEL) && channels.candidates() > 1;
        List<String> notes = choice
                ? List.of("heights from channel " + chosen.label() + "; the file has " + channels.names())
                : List.of();
        return new MeasuredHeights(map, source, channels.lines(), notes);
    }

    /** Whether a file knows its own scale, or most of it; false for images and for what cannot be read. */
    static boolean isScan(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (ScanBytes bytes = ScanBytes.open(file)) {
            Optional<ScanReader> reader = ScanFormats.find(bytes, Optional.empty());
            return reader.isPresent() && !ScanFormats.isPicture(reader.get());
        } catch (ScanException | IOException unreadable) {
            // Whoever reads the heights says what is wrong.
            return false;
        }
    }
}
