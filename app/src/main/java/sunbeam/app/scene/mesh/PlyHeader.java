package sunbeam.app.scene.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import sunbeam.precompute.files.InputException;
import sunbeam.precompute.scan.SampleType;
import sunbeam.precompute.text.Quoted;

/** Header of a PLY file, with its elements in the file's order. */
record PlyHeader(Encoding encoding, List<Element> elements) {
    private static final int MOST_LINES = 1000;
    private static final int LONGEST_LINE = 1000;

    enum Encoding {
        ASCII,
        BINARY_LITTLE_ENDIAN,
        BINARY_BIG_ENDIAN
    }

    /** Column of numbers, or of lists whose length has a type. */
    record Property(String name, Optional<SampleType> length, SampleType type) {}

    record Element(String name, int count, List<Property> properties) {

        /** Returns the first of these names that occurs, or -1. */
        int column(String... names) {
            List<String> all = properties.stream().map(Property::name).toList();
            return Stream.of(names)
                    .mapToInt(all::indexOf)
                    .filter(column -> column >= 0)
                    .findFirst()
                    .orElse(-1);
        }
    }

    static PlyHeader read(InputStream stream) throws IOException {
        Encoding encoding = null;
        List<Element> elements = new ArrayList<>();
        for (int number = 1; number <= MOST_LINES; number++) {
            String line = line(stream);
            String[] words = line.strip().split("\\s+");
            try {
                switch (words[0]) {
                    case "format" -> encoding = Encoding.valueOf(words[1].toUpperCase(Locale.ROOT));
                    case "element" -> elements.add(element(words));
                    case "property" ->
                        elements.get(elements.size() - 1).properties().add(property(words));
                    case "end_header" -> {
                        if (encoding == null) {
                            throw new IllegalArgumentException("no format line is above it");
                        }
                        return new PlyHeader(encoding, elements);
                    }
                    case "ply", "comment", "obj_info" -> {
                        // No geometry.
                    }
                    default -> throw new IllegalArgumentException("no such line is known");
                }
            } catch (IllegalArgumentException | IndexOutOfBoundsException wrong) {
                throw new InputException(
                        "line " + number + " of the header, " + Quoted.of(line)
                                + ", cannot be understood; export the mesh again",
                        wrong);
            }
        }
        throw new InputException("the header has more than " + MOST_LINES + " lines; export the mesh again");
    }

    /** Empty at the end of the file. */
    private static String line(InputStream stream) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int next = stream.read(); next != '\n' && next >= 0; next = stream.read()) {
            line.append((char) next);
            InputException.refuseIf(
                    line.length() > LONGEST_LINE,
                    "a line of the header is longer than " + LONGEST_LINE + " characters; export the mesh again");
        }
        return line.toString();
    }

    private static Element element(String[] words) {
        int count = Integer.parseInt(words[2]);
        if (count < 0) {
            throw new IllegalArgumentException("a negative count");
        }
        return new Element(words[1], count, new ArrayList<>());
    }

    private static Property property(String[] words) {
        return words[1].equals("list")
                ? new Property(words[4], Optional.of(type(words[2])), type(words[3]))
                : new Property(words[2], Optional.empty(), type(words[1]));
    }

    private static SampleType type(String name) {
        return switch (name) {
            case "char", "int8" -> SampleType.SIGNED_8;
            case "uchar", "uint8" -> SampleType.UNSIGNED_8;
            case "short", "int16" -> SampleType.SIGNED_16;
            case "ushort", "uint16" -> SampleType.UNSIGNED_16;
            case "int", "int32" -> SampleType.SIGNED_32;
            case "uint", "uint32" -> SampleType.UNSIGNED_32;
            case "float", "float32" -> SampleType.FLOAT_32;
            case "double", "float64" -> SampleType.FLOAT_64;
            default -> throw new IllegalArgumentException("no type " + name);
        };
    }
}
