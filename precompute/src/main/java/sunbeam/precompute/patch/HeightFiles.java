package sunbeam.precompute.patch;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanReader;
import sunbeam.precompute.scan.format.GwyddionConversion;
import sunbeam.precompute.scan.format.ScanFormats;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/** Reads heights in metres from scans, which know their scale or most of it, and from images, which know none. */
final class HeightFiles {
    private HeightFiles() {}

    /**
     * The heights of a file.
     *
     * @param choices of {@link PatchSettings#OF_FILES}
     * @throws PatchException when the file cannot be used
     * @throws SettingException when what was chosen contradicts it or is absurd, or something must be chosen
     */
    static MeasuredHeights read(Path file, Choices choices) {
        InputFiles.requireReadable(file);
        MeasuredHeights heights = readAny(file, choices);
        ReliefCheck.requireContent(heights.map(), file);
        return heights;
    }

    private static MeasuredHeights readAny(Path file, Choices choices) {
        try (ScanBytes bytes = ScanBytes.open(file)) {
            Optional<ScanReader> reader = ScanFormats.find(bytes);
            if (reader.isPresent()) {
                String format = reader.get().format();
                return new ScanHeights(file, format, choices).read(reader.get().channels(bytes));
            }
            return ImageFormat.isPicture(bytes.head(4)) ? fromImage(file, choices) : throughGwyddion(file, choices);
        } catch (ScanException unusable) {
            throw new PatchException(file + " " + unusable.getMessage(), unusable);
        } catch (IOException failure) {
            throw new PatchException(
                    String.format(Locale.ROOT, "%s cannot be read (%s); check the file", file, failure.getMessage()),
                    failure);
        }
    }

    private static MeasuredHeights throughGwyddion(Path file, Choices choices) throws IOException {
        GwyddionConversion gwyddion = new GwyddionConversion(System.getenv());
        if (!gwyddion.isInstalled()) {
            throw new ScanException("is neither an image nor a scan in a format that Sunbeam knows;"
                    + " install Gwyddion (the command gwyddion, and xvfb-run where there is no display), through"
                    + " which Sunbeam reads 170 others, or export it as .gwy, .gsf or text");
        }
        Path folder = temporaryFolder();
        try {
            Path converted = gwyddion.convert(file, folder);
            try (ScanBytes bytes = ScanBytes.open(converted)) {
                ScanReader reader = ScanFormats.find(bytes)
                        .orElseThrow(() -> new ScanException("is converted by Gwyddion to nothing that can be read"));
                return new ScanHeights(file, "through Gwyddion", choices).read(reader.channels(bytes));
            }
        } finally {
            for (String name : GwyddionConversion.FILES) {
                Files.deleteIfExists(folder.resolve(name));
            }
            Files.deleteIfExists(folder);
        }
    }

    private static Path temporaryFolder() {
        Path shared = Path.of(System.getProperty("java.io.tmpdir"));
        try {
            return Files.createTempDirectory(shared, "sunbeam-");
        } catch (IOException full) {
            String reason = full instanceof FileSystemException failure && failure.getReason() != null
                    ? failure.getReason()
                    : full.getClass().getSimpleName();
            throw new ScanException(
                    "is in a format that Sunbeam reads through Gwyddion, whose result finds no place in the"
                            + " folder for temporary files, " + shared + " (" + reason
                            + "); free some space there, or export it as .gwy, .gsf or text");
        }
    }

    /** Whether a file knows its own scale, or most of it; false for images and for what cannot be read. */
    static boolean isScan(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (ScanBytes bytes = ScanBytes.open(file)) {
            return ScanFormats.find(bytes).isPresent();
        } catch (ScanException | IOException unreadable) {
            // Whoever reads the heights says what is wrong.
            return false;
        }
    }

    private static MeasuredHeights fromImage(Path file, Choices choices) {
        if (choices.has(PatchSettings.COLUMNS)) {
            throw new SettingException(
                    PatchSettings.COLUMNS, "is for numbers without rows, but " + file + " is an image; leave it out");
        }
        Optional<Channel> channel = choices.find(PatchSettings.CHANNEL).map(Channel::of);
        PatchScale scale = PatchScale.of(choices, file.toString());
        HeightImage image = HeightImageReader.read(file, channel);
        HeightMap map = scale.apply(image);
        // Pictures are published with it: the file's name, not the folders of its owner.
        String source = String.format(
                Locale.ROOT,
                "%s (%s), %s, full scale %s",
                file.getFileName(),
                image.description(),
                map.describe(),
                Lengths.format(scale.maxHeight()));
        List<String> warnings = scale.warnings(map, image.format(), choices.origin(PatchSettings.MAX_HEIGHT));
        return new MeasuredHeights(map, source, List.of(), List.of(), warnings);
    }
}
