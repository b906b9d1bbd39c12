package sunbeam.app.longrun;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Predicate;
import java.util.stream.Stream;
import javax.imageio.ImageIO;

/** Pieces of work that take long because of their number of parts, made small here. */
enum LongWork {
    /** Twenty-one pictures of three small patches; a part is a picture. The cache has their tables. */
    FIGURES {
        @Override
        void prepare(Place place) throws IOException {
            Path patches = Files.createDirectories(place.folder().resolve("patches"));
            for (String name : List.of("blaze", "elaphe", "xenopeltis")) {
                BufferedImage image = new BufferedImage(24, 24, BufferedImage.TYPE_BYTE_GRAY);
                for (int i = 0; i < 24 * 24; i++) {
                    image.getRaster().setSample(i % 24, i / 24, 0, i % 24 * (5 + name.length() / 2));
                }
                ImageIO.write(image, "png", patches.resolve(name + ".png").toFile());
                Files.writeString(
                        patches.resolve(name + ".json"),
                        "{\"heights\": \"" + name + ".png\", \"width\": \"2.5 um\", \"maxHeight\": \"250 nm\"}");
            }
        }

        @Override
        List<String> command(Place place) {
            return List.of("figures --only 5.3,5.4 --size 24 --patches patches --output out".split(" "));
        }

        @Override
        Map<String, String> parts(Place place) {
            return files(place.folder().resolve("out"), name -> name.endsWith(".png"), LongWork::identity);
        }
    },
    /** Twelve frames and a GIF; a part is a frame. */
    ANIMATION {
        @Override
        List<String> command(Place place) {
            return List.of(
                    ("render elaphe --mesh plane --patch blaze --texture none --method full --tolerance 0.02 --size 32x24 --turntable 12 --resume"
                                    + " --output out")
                            .split(" "));
        }

        @Override
        Map<String, String> parts(Place place) {
            return files(place.folder().resolve("out"), name -> name.startsWith("frame-"), LongWork::identity);
        }
    },
    /** A table of colors and a map from it; a part is a batch of colors. Each has a cache of its own. */
    TABLE {
        @Override
        List<String> command(Place place) {
            return List.of("brdf-map --method table --patch blaze --size 24 --tolerance 0.003 --force --output out.png"
                    .split(" "));
        }

        @Override
        Path cache(Place place) {
            return place.folder().resolve("cache");
        }

        /** Until the table is there in their place. */
        @Override
        boolean partsStay(Place place) {
            return files(cache(place).resolve("sunbeam"), name -> name.endsWith(".tables"), LongWork::identity)
                    .isEmpty();
        }

        @Override
        Map<String, String> parts(Place place) {
            Map<String, String> parts = new TreeMap<>();
            UnfinishedColors.find(cache(place)).forEach(file -> parts.putAll(UnfinishedColors.batches(file)));
            return parts;
        }

        @Override
        int finished(Place place) {
            return UnfinishedColors.count(cache(place));
        }

        @Override
        UnfinishedColors.Watch watch(Place place) {
            return UnfinishedColors.watch(cache(place));
        }

        @Override
        Map<String, String> result(Place place) {
            Map<String, String> result = files(place.folder(), name -> name.endsWith(".png"), LongWork::content);
            result.putAll(files(cache(place).resolve("sunbeam"), name -> !name.endsWith(".lock"), LongWork::content));
            return result;
        }
    },
    /** Pages of a scene's colors and a picture of them; a part is a page. Each has a cache of its own. */
    PAGES {
        @Override
        List<String> command(Place place) {
            return List.of(("render elaphe --mesh plane --patch blaze --texture none --method table --tolerance 0.01"
                            + " --size 160x120 --force --output out.png")
                    .split(" "));
        }

        @Override
        Path cache(Place place) {
            return place.folder().resolve("cache");
        }

        @Override
        Map<String, String> parts(Place place) {
            Map<String, String> parts = new TreeMap<>();
            KeptPageRecords.find(cache(place)).forEach(file -> parts.putAll(KeptPageRecords.of(file)));
            return parts;
        }

        @Override
        int finished(Place place) {
            return KeptPageRecords.count(cache(place));
        }

        /** The picture, and the pages in whatever order they were made. */
        @Override
        Map<String, String> result(Place place) {
            Map<String, String> result = files(place.folder(), name -> name.endsWith(".png"), LongWork::content);
            result.putAll(parts(place));
            return result;
        }
    };

    /**
     * Where it is done.
     *
     * @param folder the working folder
     * @param cache of tables, which all runs share
     */
    record Place(Path folder, Path cache) {}

    /** Makes the folder's inputs. */
    void prepare(Place place) throws IOException {
        Files.createDirectories(place.folder());
    }

    /** The command line, the same for a first run and for the one that goes on. */
    abstract List<String> command(Place place);

    /** What is finished, by name, with what would change were it made again. */
    abstract Map<String, String> parts(Place place);

    /** Whether the parts are still there; others have what they were for in their place. */
    boolean partsStay(Place place) {
        return true;
    }

    /** About how many parts are finished, quickly, while a process works. */
    int finished(Place place) {
        return parts(place).size();
    }

    Path cache(Place place) {
        return place.cache();
    }

    /** Looks on while a run goes on; this one at nothing. */
    UnfinishedColors.Watch watch(Place place) {
        return UnfinishedColors.nothing();
    }

    /** The files that a run leaves in the end, save for times. */
    Map<String, String> result(Place place) {
        return files(place.folder().resolve("out"), name -> true, LongWork::content);
    }

    private interface Look {
        String at(Path file);
    }

    static Map<String, String> files(Path folder, Predicate<String> wanted, Look look) {
        Map<String, String> all = new TreeMap<>();
        if (!Files.isDirectory(folder)) {
            return all;
        }
        try (Stream<Path> files = Files.list(folder)) {
            files.filter(file -> wanted.test(file.getFileName().toString()))
                    // What a killed process was writing goes when the next one writes there.
                    .filter(file -> !file.getFileName().toString().startsWith(".sunbeam-"))
                    .forEach(file -> all.put(file.getFileName().toString(), look.at(file)));
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
        return all;
    }

    static String content(Path file) {
        try {
            return Files.readString(file, StandardCharsets.ISO_8859_1);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }

    /** A file that was written again is another one, or has another time. */
    static String identity(Path file) {
        try {
            return Files.getAttribute(file, "unix:ino") + " " + Files.getLastModifiedTime(file);
        } catch (IOException failure) {
            throw new UncheckedIOException(failure);
        }
    }
}
