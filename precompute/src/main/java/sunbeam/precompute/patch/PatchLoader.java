package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CHANNEL;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.PATCH;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import sunbeam.precompute.files.FileNames;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.files.OwnFolder;
import sunbeam.precompute.optics.HeightMap;
import sunbeam.precompute.patch.builtin.BuiltInPatches;
import sunbeam.precompute.prepare.Leveling;
import sunbeam.precompute.scan.ScanBytes;
import sunbeam.precompute.scan.ScanException;
import sunbeam.precompute.scan.ScanFormat;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.JsonObject;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.text.Text;

/** Loads a built-in patch, else a descriptor (*.json), else a scan or an image. A file called like a built-in patch needs its folder. */
public final class PatchLoader {
    private PatchLoader() {}

    /** Loads a patch; throws InputException if it or its file cannot be used, SettingException if a choice is absurd. */
    public static Patch load(PatchRequest request, HeightCache cache) {
        return request.located(() -> loadHere(request, cache));
    }

    /** True for a file of a scan or of numbers; false for images, descriptors and unreadable files. */
    public static boolean isScan(Path file) {
        if (!Files.isRegularFile(file)) {
            return false;
        }
        try (ScanBytes bytes = ScanBytes.open(file)) {
            return ScanFormat.find(bytes, Optional.empty())
                    .filter(format -> !format.isPicture())
                    .isPresent();
        } catch (ScanException | IOException unreadable) {
            return false;
        }
    }

    /** Returns the file of a descriptor's heights; empty if the file is no descriptor, or names heights outside its folder. */
    public static Optional<Path> described(Path file) {
        try {
            return isDescriptor(file.toString())
                    ? Optional.of(PatchDescriptor.read(file).heights())
                    : Optional.empty();
        } catch (InputException | SettingException unusable) {
            return Optional.empty();
        }
    }

    private static boolean isDescriptor(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(".json");
    }

    private static Patch loadHere(PatchRequest request, HeightCache cache) {
        String name = request.patch().strip();
        if (BuiltInPatches.names().contains(name)) {
            return fromBuiltIn(name, request, cache);
        }
        Path file = existing(request.patch());
        PatchAssembler.Kind kind = request.raw() ? PatchAssembler.Kind.DESCRIBED : PatchAssembler.Kind.GIVEN_DIRECTLY;
        return isDescriptor(name)
                ? fromDescriptor(PatchDescriptor.read(file), request)
                : fromFile(file, file, request.choices(), kind);
    }

    private static Path existing(String given) {
        if (given.isBlank()) {
            throw unusable("is empty; ");
        }
        try {
            return Stream.of(given, given.strip())
                    .map(Path::of)
                    .filter(Files::exists)
                    .findFirst()
                    .orElseThrow(() -> unusable("is neither a built-in patch nor an existing file; "));
        } catch (InvalidPathException e) {
            throw unusable("is no file name (" + e.getReason() + "); ");
        }
    }

    private static SettingException unusable(String problem) {
        String remedy = "give a built-in patch (" + String.join(", ", BuiltInPatches.names())
                + "), a scan, a descriptor (.json) or an image with ";
        return new SettingException(PATCH, problem + remedy, WIDTH, " and ", MAX_HEIGHT);
    }

    private static Patch fromBuiltIn(String name, PatchRequest request, HeightCache cache) {
        String what = "the built-in patch " + name;
        // Only heights with the default leveling are cached.
        HeightMap map = request.choices().has(PatchSettings.LEVEL)
                ? BuiltInPatches.generate(name)
                : cache.get(name, () -> Leveling.MEAN.apply(BuiltInPatches.generate(name)));
        requireNoScale(request, what);
        if (request.choices().has(CHANNEL)) {
            throw new SettingException(CHANNEL, "contradicts " + what + ", which is no scan or image; leave it out");
        }
        String source = "built-in " + name + ", " + map.describe();
        MeasuredHeights made = new MeasuredHeights(map, source, List.of(), List.of());
        return new PatchAssembler(name, name, request.choices(), PatchAssembler.Kind.BUILT_IN).patch(made);
    }

    private static Patch fromDescriptor(PatchDescriptor descriptor, PatchRequest request) {
        String what = descriptor.file().toString();
        requireNoScale(request, what);
        Choices described = descriptor.choices();
        for (Setting<?> setting : PatchSettings.OF_FILES) {
            boolean both = request.choices().has(setting) && described.has(setting);
            if (both && !request.choices().find(setting).equals(described.find(setting))) {
                throw new SettingException(
                        setting,
                        "contradicts " + what + ", which says " + described.written(setting)
                                + "; leave it out or edit the descriptor");
            }
        }
        Choices all = described.over(request.choices());
        return all.located(() -> fromFile(descriptor.file(), descriptor.heights(), all, PatchAssembler.Kind.DESCRIBED));
    }

    private static void requireNoScale(PatchRequest request, String what) {
        for (Setting<?> setting : PatchSettings.SCALE) {
            if (request.choices().has(setting)) {
                throw new SettingException(
                        setting, "contradicts " + what + ", which has its own scale; leave it out, or name an image");
            }
        }
    }

    private static Patch fromFile(Path file, Path heightsFile, Choices choices, PatchAssembler.Kind kind) {
        MeasuredHeights measured = MeasuredHeights.read(heightsFile, choices);
        return new PatchAssembler(FileNames.stem(file), heightsFile.toString(), choices, kind).patch(measured);
    }

    /** Cache of built-in patches, whose generation takes half a second. */
    public interface HeightCache {
        HeightCache NONE = (name, generated) -> generated.get();

        HeightMap get(String name, Supplier<HeightMap> generated);
    }

    /**
     * JSON file that describes a patch: {@code "heights"}, a file in the descriptor's folder or below, {@link PatchSettings#OF_FILES}, and a
     * {@code "note"}, which the program ignores. Descriptors are untrusted, so they may name no file outside their folder.
     */
    record PatchDescriptor(Path file, Path heights, Choices choices) {
        /**
         * @throws InputException if the descriptor cannot be read or is malformed, or its heights are missing
         * @throws SettingException if one of its values cannot be used
         */
        static PatchDescriptor read(Path file) {
            JsonObject keys = JsonObject.read(file);
            String heights = keys.text("heights", keys.required("heights", "\"scan.png\""));
            Path inside = inside(file, keys.name("heights"), heights);
            Choices choices = keys.choices(PatchSettings.OF_FILES);
            keys.find("note").ifPresent(value -> keys.text("note", value));
            keys.requireNoOthers();
            return new PatchDescriptor(file, inside, choices);
        }

        /** In the descriptor's folder or below after all links are followed. */
        private static Path inside(Path descriptor, String name, String heights) {
            InputException.refuseIf(heights.isBlank(), name + " is empty; name a file in the descriptor's own folder");
            try {
                OwnFolder folder = new OwnFolder(descriptor, "descriptor");
                Path file = folder.file(heights);
                InputException.refuseIf(
                        !Files.exists(file),
                        name + " is " + Text.quoted(heights) + ", but there is no file " + file + "; check the name");
                folder.requireNoWayOut(file);
                return file;
            } catch (IllegalArgumentException wrong) {
                throw new InputException(name + " " + Text.quoted(heights) + " " + wrong.getMessage(), wrong);
            }
        }
    }
}
