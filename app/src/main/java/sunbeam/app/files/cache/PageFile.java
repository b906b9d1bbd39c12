package sunbeam.app.files.cache;

import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import sunbeam.precompute.colortable.KeptPages;
import sunbeam.precompute.colortable.LevelBaking;
import sunbeam.precompute.colortable.NumberFormat;
import sunbeam.precompute.table.TableLabel;

/** Pages of one surface's levels of colors in the cache folder: a record each, coefficients as the shader has them. */
public final class PageFile implements KeptPages {
    private final RecordFile records;
    private final Runnable closed;

    private PageFile(RecordFile records, Runnable closed) {
        this.records = records;
        this.closed = closed;
    }

    /**
     * Goes on with a file, or begins one. Where that cannot be done, nothing is kept.
     *
     * @param key all that determines the pages
     * @param numbers of their coefficients
     * @param mostBytes that the file may take
     * @param warning told in one line, once, what is wrong with it
     * @param closed told when it has been closed
     */
    public static KeptPages of(
            Path file,
            String key,
            NumberFormat numbers,
            TableLabel label,
            long mostBytes,
            Consumer<String> warning,
            Runnable closed) {
        Optional<RecordFile> records = RecordFile.open(
                file,
                key + numbers + ByteOrder.nativeOrder(),
                numbers.bytes() * LevelBaking.PAGE_NUMBERS,
                label,
                mostBytes,
                warning);
        return records.isPresent() ? new PageFile(records.get(), closed) : NONE;
    }

    private static long number(int level, int page) {
        return (long) level << Integer.SIZE | page;
    }

    @Override
    public BitSet kept(int level, BitSet pages) {
        BitSet kept = new BitSet();
        pages.stream().filter(page -> records.has(number(level, page))).forEach(kept::set);
        return kept;
    }

    @Override
    public Map<Integer, byte[]> read(int level, BitSet pages) {
        Map<Integer, byte[]> found = new HashMap<>();
        records.read(pages.stream().mapToObj(page -> number(level, page)).collect(Collectors.toSet()))
                .forEach((number, content) -> found.put(number.intValue(), content));
        return found;
    }

    @Override
    public void keep(int level, Map<Integer, byte[]> pages) {
        Map<Long, byte[]> contents = new TreeMap<>();
        pages.forEach((page, content) -> contents.put(number(level, page), content));
        records.append(contents);
    }

    @Override
    public void close() {
        records.close();
        closed.run();
    }
}
