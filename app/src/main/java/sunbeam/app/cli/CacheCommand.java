package sunbeam.app.cli;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import sunbeam.app.files.cache.CacheFolder;
import sunbeam.app.files.output.OutputException;
import sunbeam.app.terminal.ByteSize;
import sunbeam.app.terminal.ExitCode;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.plan.TableLabel;
import sunbeam.precompute.text.Text;

/** {@code sunbeam cache}: lists and deletes cached tables. */
@Command(
        name = "cache",
        header = "List, limit or clear the tables that are kept.",
        description =
                "Tables that took time to make, and textures and heights that the program makes itself, are kept in the folder that"
                        + " sunbeam --help names, and read again when the same is needed. Without an option, lists them, those used last"
                        + " first: size, when it was last used, for which surface it was made, and what it is. They take 2 GB at most, or"
                        + " as much as the variable SUNBEAM_CACHE_LIMIT says. Removing them costs time only; other processes that use one go on with it.",
        footer = {"  sunbeam cache --clear"})
public final class CacheCommand extends ReportingCommand {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm", Locale.ROOT);

    @Mixin
    private final JsonOption json = new JsonOption();

    @Option(names = "--clear", description = "Remove all tables.")
    private boolean clear;

    @Override
    public Integer call() {
        CacheFolder folder = CacheFolder.of(environment());
        if (clear) {
            clear(folder);
        } else {
            list(folder);
        }
        return ExitCode.OK.code();
    }

    private void clear(CacheFolder folder) {
        List<CacheFolder.Entry> left = new ArrayList<>(folder.entries());
        List<CacheFolder.Entry> removed = folder.clear();
        json.text(out()).println(folder.path() + ": removed " + count(removed));
        left.removeAll(removed);
        if (left.stream().anyMatch(entry -> Files.exists(entry.file()))) {
            throw new OutputException("cannot remove " + count(left) + " from " + folder.path()
                    + ": the folder is not yours to write to, or another program has them open; change its permissions, or"
                    + " try again later");
        }
        report(folder, "removed", removed);
    }

    /** With {@code --json} prints files of the cache, under the name that says whether they are still there. */
    private void report(CacheFolder folder, String name, List<CacheFolder.Entry> entries) {
        if (!json.isGiven()) {
            return;
        }
        Map<String, Object> report = new LinkedHashMap<>();
        report.put("folder", folder.path().toString());
        report.put("limit_bytes", folder.limit());
        report.put(name, entries.stream().map(CacheCommand::fields).toList());
        json.print(out(), report, List.of());
    }

    private static Map<String, Object> fields(CacheFolder.Entry entry) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("file", entry.file().toString());
        fields.put("bytes", entry.bytes());
        fields.put("last_used", entry.lastUsed().toString());
        if (Files.exists(entry.file())) {
            TableLabel label = label(entry);
            fields.put("patch", label.patch());
            fields.put("what", label.what());
        }
        return fields;
    }

    private void list(CacheFolder folder) {
        List<CacheFolder.Entry> entries = folder.entries();
        report(folder, "entries", entries);
        PrintWriter out = json.text(out());
        out.println(folder.path() + ": " + count(entries) + " of at most " + ByteSize.format(folder.limit()));
        if (!entries.isEmpty()) {
            out.println();
            out.println("      size  last used         for                       what");
        }
        for (CacheFolder.Entry entry : entries) {
            TableLabel label = label(entry);
            String size = ByteSize.format(entry.bytes());
            String time = TIME.format(entry.lastUsed().atZone(ZoneId.systemDefault()));
            out.println(Text.format("  %8s  %s  %-24s  %s", size, time, label.patch(), label.what()));
        }
    }

    private static TableLabel label(CacheFolder.Entry entry) {
        try {
            return entry.label();
        } catch (InputException unusable) {
            // The list's heading already names the folder.
            String why = unusable.getMessage().replace(entry.file() + ": ", "");
            return new TableLabel("?", "not usable, will be made again or removed: " + why);
        }
    }

    private static String count(List<CacheFolder.Entry> entries) {
        long bytes = entries.stream().mapToLong(CacheFolder.Entry::bytes).sum();
        return Text.format("%d file%s, %s", entries.size(), entries.size() == 1 ? "" : "s", ByteSize.format(bytes));
    }
}
