package sunbeam.precompute.scan.format;

import java.util.ArrayList;
import java.util.List;

/** Uncompressed TIFF files with any tags; values follow the directory of their page. */
final class TestTiff {
    private static final int BYTES = 1;
    private static final int TEXT = 2;
    private static final int SHORT = 3;
    private static final int LONG = 4;
    private static final int DOUBLE = 12;

    private record Tag(int tag, int type, int count, byte[] value) {}

    private final TestBytes order;
    private final List<Page> pages = new ArrayList<>();

    /** @param order empty, for its byte order */
    TestTiff(TestBytes order) {
        this.order = order;
    }

    Page page() {
        pages.add(new Page());
        return pages.get(pages.size() - 1);
    }

    /** One directory; tags are to be added in ascending order. */
    final class Page {
        private final List<Tag> tags = new ArrayList<>();
        private int dataTag;

        Page number(int tag, int type, int value) {
            TestBytes bytes = order.fresh();
            return add(tag, type, 1, type == SHORT ? bytes.int16(value).int16(0) : bytes.int32(value));
        }

        Page number(int tag, double value) {
            return add(tag, DOUBLE, 1, order.fresh().float64(value));
        }

        Page text(int tag, String text) {
            return add(tag, TEXT, text.length() + 1, order.fresh().text(text + "\0"));
        }

        Page bytes(int tag, byte[] value) {
            return add(tag, BYTES, value.length, order.fresh().bytes(value));
        }

        /** One strip of samples, with the tags for its place and its length. */
        Page data(int offsetTag, int lengthTag, byte[] samples) {
            dataTag = offsetTag;
            bytes(offsetTag, samples);
            return number(lengthTag, LONG, samples.length);
        }

        private Page add(int tag, int type, int count, TestBytes value) {
            tags.add(new Tag(tag, type, count, value.array()));
            return this;
        }
    }

    byte[] array() {
        TestBytes file = order.fresh();
        file.text(order.isLittle() ? "II" : "MM").int16(42).int32(8);
        for (int i = 0; i < pages.size(); i++) {
            write(file, pages.get(i), i + 1 == pages.size());
        }
        return file.array();
    }

    private void write(TestBytes file, Page page, boolean last) {
        int behind = file.size() + 2 + 12 * page.tags.size() + 4;
        TestBytes values = order.fresh();
        file.int16(page.tags.size());
        for (Tag tag : page.tags) {
            boolean data = tag.tag == page.dataTag;
            file.int16(tag.tag).int16(data ? LONG : tag.type).int32(data ? 1 : tag.count);
            if (tag.value.length > 4 || data) {
                file.int32(behind + values.size());
                values.bytes(tag.value);
            } else {
                file.bytes(tag.value).zeros(4 - tag.value.length);
            }
        }
        file.int32(last ? 0 : behind + values.size()).bytes(values.array());
    }
}
