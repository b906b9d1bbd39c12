package sunbeam.app.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.io.File;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import sunbeam.app.cli.Collection.Item;
import sunbeam.app.cli.Collection.Outcome;
import sunbeam.app.cli.PatchOptions.TaskPart;
import sunbeam.app.files.output.AtomicFile;
import sunbeam.app.files.output.CsvWriter;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.files.output.OutputFolder;
import sunbeam.app.files.output.Overwrite;
import sunbeam.app.files.output.PngWriter;
import sunbeam.app.files.output.StreamContent;
import sunbeam.app.files.plot.Sheet;
import sunbeam.app.files.plot.Sheet.Thumbnail;
import sunbeam.app.terminal.ProgressDisplay;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.work.Progress;

/**
 * Output of a collection: {@code table.csv}, {@code sheet.png} with its further pages, {@code reports.jsonl} with a line for each surface,
 * and the files of each surface in {@code surfaces}. The files of a part have its number in their names.
 */
record CollectionFolder(Path folder, String part, Map<String, ObjectNode> earlier) {
    private static final List<String> COLUMNS = List.of(
            ("/theta_i_deg /verdict_code /verdict /period_m /period_low_m /period_high_m /about_m /direction_deg"
                            + " /first_orders_deg /purest/srgb /purest/theta_r_deg /purest/dominant_m /purest/purity"
                            + " /faults /notes /warnings")
                    .split(" ", -1));
    private static final List<String> INSPECTED =
            List.of("/width_m /height_m /columns /rows /relief_m /roughness_m /rms_slope".split(" ", -1));
    private static final List<String> EVALUATED = List.of(
            "/azimuth_deg /peaks_interpolated/mean_m /peaks_interpolated/standard_error_m /peaks_at_maxima/mean_m"
                    .split(" ", -1));
    // The reports have all digits.
    private static final MathContext SHOWN = new MathContext(6);
    private static final String REPORTS = "reports";
    private static final ObjectMapper JSON = new ObjectMapper();
    private static final ObjectNode NO_SURFACE = JSON.createObjectNode();

    /** Creates the folder if it is missing, and checks that its table can be written; reads the reports of earlier runs to resume. */
    static CollectionFolder open(Path folder, TaskPart task, Overwrite overwrite, boolean resumes) {
        String part = task.parts() == 1 ? "" : "-" + task.number() + "-of-" + task.parts();
        CollectionFolder opened = new CollectionFolder(folder, part, new HashMap<>());
        OutputFolder.create(folder);
        OutputFolder.create(folder.resolve("surfaces"));
        AtomicFile.checkWritable(opened.file("table", ".csv"), overwrite);
        AtomicFile.checkWritable(opened.file(REPORTS, ".jsonl"), overwrite);
        if (resumes) {
            opened.readEarlier();
        }
        return opened;
    }

    private Path file(String stem, String ending) {
        return folder.resolve(stem + part + ending);
    }

    Path picture(String stem) {
        return folder.resolve("surfaces").resolve(stem + ".png");
    }

    /** Throws {@link OutputException} if a picture exists that may not be replaced, before any surface is examined. */
    void requireFree(List<Item> items, Overwrite overwrite) {
        for (Item item : items) {
            Path picture = picture(item.stem());
            if (overwrite == Overwrite.REFUSE && Files.exists(picture)) {
                throw new OutputException.Exists("cannot write " + picture
                        + ": it exists; add --resume to keep what is finished, or --force to make all anew");
            }
        }
    }

    private void readEarlier() {
        try (DirectoryStream<Path> files = Files.newDirectoryStream(folder, REPORTS + "*.jsonl")) {
            for (Path file : files) {
                Files.readString(file)
                        .lines()
                        .flatMap(line -> parsed(line).stream())
                        .forEach(row -> earlier.put(row.path("parameters").asText(), row));
            }
        } catch (IOException failure) {
            throw InputException.of(folder, failure);
        }
    }

    /** Parses a row; empty if it has no report, or for the unfinished line of a stopped run. */
    private Optional<ObjectNode> parsed(String line) {
        try {
            return JSON.readTree(line) instanceof ObjectNode row && row.has("report")
                    ? Optional.of(row)
                    : Optional.empty();
        } catch (JsonProcessingException unfinished) {
            return Optional.empty();
        }
    }

    /** Returns the row of an earlier run of the same surface with the same options, if its picture is still there. */
    Optional<ObjectNode> find(Item item, String hash) {
        Path picture = picture(item.stem());
        return Optional.ofNullable(earlier.get(hash))
                .filter(row -> row.path("file").asText().equals(item.patch())
                        && row.path("picture").asText().equals(picture.toString())
                        && Files.isRegularFile(picture));
    }

    /** Returns the row of a run: of the JSON that the command printed, if any, and, if it failed, of the message why. */
    ObjectNode row(Item item, String hash, Outcome outcome) {
        ObjectNode row = JSON.createObjectNode()
                .put("file", item.patch())
                .put("exit_code", outcome.code())
                .put("message", outcome.isWritten() ? "" : outcome.message())
                .put("picture", outcome.isWritten() ? picture(item.stem()).toString() : "")
                .put("parameters", hash);
        if (!outcome.out().isBlank()) {
            try {
                JsonNode tree = JSON.readTree(outcome.out());
                JsonNode surface = tree.at("/surfaces/0");
                row.set("report", surface.isMissingNode() ? tree : surface);
            } catch (JsonProcessingException impossible) {
                throw new IllegalStateException(impossible);
            }
        }
        return row;
    }

    /** Adds a new row to the reports, so that it is kept if the run is stopped. */
    void append(ObjectNode row) {
        if (row.equals(earlier.get(row.path("parameters").asText()))) {
            return;
        }
        Path file = file(REPORTS, ".jsonl");
        try {
            // Halves of surrogates, as of names that were cut, become question marks instead of an error.
            byte[] line = (row + "\n").getBytes(StandardCharsets.UTF_8);
            Files.write(file, line, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
        } catch (IOException failure) {
            throw OutputException.of(file, failure);
        }
    }

    List<Path> write(String command, List<ObjectNode> rows, ProgressDisplay display) {
        List<Path> written = new ArrayList<>();
        String lines = rows.stream().map(row -> row + "\n").collect(Collectors.joining());
        AtomicFile.write(file(REPORTS, ".jsonl"), Overwrite.REPLACE, StreamContent.of(lines));
        String table = CsvWriter.text(
                List.copyOf(cells(command, NO_SURFACE).keySet()),
                rows.stream().map(row -> cells(command, row)).toList());
        written.add(AtomicFile.write(file("table", ".csv"), Overwrite.REPLACE, StreamContent.of(table)));
        written.add(file(REPORTS, ".jsonl"));
        Map<String, Long> files = rows.stream()
                .map(row -> row.get("file").asText())
                .distinct()
                .collect(Collectors.groupingBy(file -> name(Path.of(file)), Collectors.counting()));
        try (Progress progress = display.start("Sheets", rows.size())) {
            for (int first = 0; first < rows.size(); first += Sheet.MOST_THUMBNAILS) {
                int end = Math.min(rows.size(), first + Sheet.MOST_THUMBNAILS);
                List<Thumbnail> page = rows.subList(first, end).parallelStream()
                        .map(row -> thumbnail(row, files))
                        .toList();
                String title = command + ": surfaces " + (first + 1) + " to " + end + " of " + rows.size();
                int number = 1 + first / Sheet.MOST_THUMBNAILS;
                Path sheet = file("sheet", (number == 1 ? "" : "-" + number) + ".png");
                written.add(PngWriter.write(
                        sheet, Overwrite.REPLACE, Sheet.ofThumbnails(title, page), Map.of("Title", title)));
                progress.step(page.size());
            }
        }
        return written;
    }

    private static String name(Path file) {
        return file.getFileName().toString();
    }

    private static Map<String, String> cells(String command, ObjectNode row) {
        Map<String, String> cells = new LinkedHashMap<>();
        List.of("file", "exit_code", "message")
                .forEach(name -> cells.put(name, row.path(name).asText()));
        List<String> own = switch (command) {
            case "inspect" -> INSPECTED;
            case "evaluate" -> EVALUATED;
            default -> List.of();
        };
        Stream.concat(COLUMNS.stream(), own.stream())
                .forEach(pointer -> cells.put(
                        pointer.substring(1).replace('/', '_'),
                        cell(row.path("report").at(pointer))));
        cells.put("picture", row.path("picture").asText());
        return cells;
    }

    private static String cell(JsonNode value) {
        String between = value.path(0).isNumber() ? " to " : "; ";
        return value.isArray()
                ? value.valueStream().map(CollectionFolder::cell).collect(Collectors.joining(between))
                : value.isDouble()
                        ? Double.toString(
                                new BigDecimal(value.asDouble()).round(SHOWN).doubleValue())
                        : value.asText("");
    }

    /** @param files number of files by name; a file that shares its name is shown with its folder's */
    private static Thumbnail thumbnail(ObjectNode row, Map<String, Long> files) {
        Path file = Path.of(row.get("file").asText());
        String name = files.get(name(file)) > 1 && file.getNameCount() > 1
                ? name(file.getParent()) + File.separator + name(file)
                : name(file);
        JsonNode report = row.path("report");
        if (row.path("picture").asText().isEmpty()) {
            return new Thumbnail(Optional.empty(), name, row.get("message").asText());
        }
        Path picture = Path.of(row.get("picture").asText());
        double theta = report.path("theta_i_deg").asDouble();
        String sentence = report.path("verdict").asText().split(": ", 2)[0];
        try {
            BufferedImage whole = Objects.requireNonNull(ImageIO.read(picture.toFile()));
            JsonNode area = report.path("thumbnail_px");
            Rectangle all = new Rectangle(whole.getWidth(), whole.getHeight());
            Rectangle part = all.intersection(new Rectangle(
                    area.path(0).asInt(),
                    area.path(1).asInt(),
                    area.path(2).asInt(),
                    area.path(3).asInt()));
            Rectangle shown = part.isEmpty() ? all : part;
            return new Thumbnail(
                    Optional.of(Thumbnail.reduced(whole.getSubimage(shown.x, shown.y, shown.width, shown.height))),
                    theta == 0 ? name : name + ", light at " + Decimals.format(theta) + "\u00b0",
                    sentence);
        } catch (IOException | RuntimeException broken) {
            return new Thumbnail(
                    Optional.empty(), name, "its picture cannot be read any more: remove it, add --resume");
        }
    }
}
