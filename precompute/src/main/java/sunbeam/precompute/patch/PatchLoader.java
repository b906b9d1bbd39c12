package sunbeam.precompute.patch;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Function;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Lengths;

/**
 * Makes patches of what users name: first a built-in patch of that name, then a descriptor (the name ends in .json),
 * then an image, which needs a scale. A file called like a built-in patch is reached as {@code ./blaze}.
 */
public final class PatchLoader {
    private final List<String> builtIn;
    private final Function<String, HeightMap> generator;

    /**
     * @param builtIn names of the patches that need no file, in the order in which they are shown to users
     * @param generator makes the heights of the patch of such a name, metres
     */
    public PatchLoader(List<String> builtIn, Function<String, HeightMap> generator) {
        this.builtIn = List.copyOf(builtIn);
        this.generator = generator;
    }

    /**
     * Loads, levels and completes a patch.
     *
     * @throws PatchException when there is no such patch, it cannot be used, or options contradict it
     */
    public Patch load(PatchRequest request) {
        String name = request.patch().strip();
        if (name.isEmpty()) {
            throw new PatchException("--patch is empty; " + choices());
        }
        if (builtIn.contains(name)) {
            return fromBuiltIn(name, generator.apply(name), request);
        }
        Path file = existing(name);
        return name.toLowerCase(Locale.ROOT).endsWith(".json")
                ? fromDescriptor(PatchDescriptorReader.read(file), request)
                : fromImage(file, request);
    }

    private Path existing(String name) {
        try {
            Path file = Path.of(name);
            if (Files.exists(file)) {
                return file;
            }
        } catch (InvalidPathException e) {
            throw new PatchException(
                    "--patch " + Quoted.of(name) + " is no file name (" + e.getReason() + "); " + choices(), e);
        }
        throw new PatchException("--patch " + Quoted.of(name) + ": no such file; " + choices());
    }

    private String choices() {
        String names = builtIn.isEmpty() ? "" : "a built-in patch (" + String.join(", ", builtIn) + "), ";
        return "give " + names + "a descriptor (.json) or an image with --width and --max-height";
    }

    private static Patch fromBuiltIn(String name, HeightMap map, PatchRequest request) {
        String what = "the built-in patch " + name;
        request.requireNoScale(what);
        if (request.channel().isPresent()) {
            throw new PatchException("--channel contradicts " + what + ", which is no image; leave --channel out");
        }
        String source = "built-in " + name + ", " + size(map);
        return finish(name, name, map, request.levelling(), source, List.of());
    }

    private static Patch fromDescriptor(PatchDescriptor descriptor, PatchRequest request) {
        String what = descriptor.file().toString();
        request.requireNoScale(what);
        return fromScaledImage(
                descriptor.file(),
                descriptor.heights(),
                descriptor.scale(),
                agreed("--channel", request.channel(), descriptor.channel(), what),
                agreed("--level", request.levelling(), descriptor.levelling(), what));
    }

    /** The one value that is given, or the same value given twice. */
    private static <T> Optional<T> agreed(String option, Optional<T> asked, Optional<T> described, String what) {
        if (asked.isPresent() && described.isPresent() && !asked.equals(described)) {
            throw new PatchException("%s %s contradicts %s, which says %s; leave %s out or edit the descriptor"
                    .formatted(option, label(asked.get()), what, label(described.get()), option));
        }
        return asked.or(() -> described);
    }

    private static String label(Object value) {
        return value.toString().toLowerCase(Locale.ROOT);
    }

    private static Patch fromImage(Path file, PatchRequest request) {
        InputFiles.requireReadable(file);
        Optional<NamedLength> width = request.namedWidth();
        Optional<NamedLength> maxHeight = request.namedMaxHeight();
        if (width.isEmpty() || maxHeight.isEmpty()) {
            String missing = width.isPresent()
                    ? "--max-height 375nm"
                    : maxHeight.isPresent() ? "--width 65um" : "--width 65um and --max-height 375nm";
            throw new PatchException("%s is an image without scale; add for example %s, or name a descriptor (.json)"
                    .formatted(file, missing));
        }
        PatchScale scale = new PatchScale(width.get(), request.namedExtent(), maxHeight.get());
        return fromScaledImage(file, file, scale, request.channel(), request.levelling());
    }

    private static Patch fromScaledImage(
            Path file, Path imageFile, PatchScale scale, Optional<Channel> channel, Optional<Levelling> levelling) {
        HeightImage image = HeightImageReader.read(imageFile, channel);
        HeightMap map = scale.apply(image);
        // Pictures are published with it: the file's name, not the folders of its owner.
        String source = "%s (%s), %s, full scale %s"
                .formatted(
                        imageFile.getFileName(),
                        image.description(),
                        size(map),
                        Lengths.format(scale.maxHeight().metres()));
        return finish(
                InputFiles.stem(file),
                imageFile.toString(),
                map,
                levelling,
                source,
                scale.warnings(map, image.format()));
    }

    private static String size(HeightMap map) {
        return "%d x %d samples, %s x %s"
                .formatted(map.columns(), map.rows(), Lengths.format(map.width()), Lengths.format(map.height()));
    }

    private static Patch finish(
            String name,
            String file,
            HeightMap measured,
            Optional<Levelling> levelling,
            String source,
            List<String> scaleWarnings) {
        List<String> warnings = new ArrayList<>(scaleWarnings);
        Levelling chosen = levelling.orElse(Levelling.MEAN);
        MissingSamples.Filled filled = fill(file, chosen.apply(measured));
        HeightMap heights = filled.heights();
        if (filled.count() > 0) {
            warnings.add(missingWarning(filled));
            // A plane fitted to filled samples would be bent by them; the mean is that of all samples again.
            heights = chosen == Levelling.NONE ? heights : Levelling.MEAN.apply(heights);
        }
        if (heights.relief() == 0) {
            warnings.add("all heights are equal: the patch is a flat mirror");
        }
        SamplingCheck.pitch(heights).ifPresent(warnings::add);
        SlopeCheck.slopes(heights).ifPresent(warnings::add);
        return new Patch(name, heights, source + ", levelling " + chosen.label(), warnings);
    }

    private static MissingSamples.Filled fill(String file, HeightMap map) {
        try {
            return MissingSamples.fill(map);
        } catch (IllegalArgumentException e) {
            throw new PatchException(
                    file + ": " + e.getMessage() + " (NaN, infinite or transparent); export the scan again", e);
        }
    }

    private static String missingWarning(MissingSamples.Filled filled) {
        long samples = (long) filled.heights().columns() * filled.heights().rows();
        return "%d of %d samples are missing and were filled from their neighbours".formatted(filled.count(), samples);
    }
}
