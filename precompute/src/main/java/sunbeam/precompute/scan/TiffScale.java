package sunbeam.precompute.scan;

import com.twelvemonkeys.imageio.metadata.tiff.TIFF;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import sunbeam.precompute.units.Decimals;

/**
 * Scale that programs write into a TIFF file: ImageJ's lines of key and value, or OME's XML, in the description of the first page, and the
 * resolution; and GDAL's scale, offset and unit of the first band. Source: ImageJ's class FileInfo; OME, "The OME model and formats", Pixels;
 * OGC, "GeoTIFF", ModelPixelScale; GDAL, "GTiff", tag GDAL_METADATA.
 */
record TiffScale(boolean isImageJ, Header description, Optional<String> pixels) {
    private static final int GEOGRAPHIC_PITCHES = 33_550;
    private static final int GDAL_METADATA = 42_112;
    // Codes of ImageJ's functions of calibration: a straight line, and two that leave the samples.
    private static final int STRAIGHT_LINE = 0;
    private static final int NONE = 20;
    private static final int NONE_OPTICAL_DENSITY = 21;

    private static final Pattern OME_PIXELS = Pattern.compile("<(?:\\w{1,20}:)?Pixels\\s([^>]{0,4000})>");

    private static final Pattern GDAL_ITEM = Pattern.compile("<Item\\s([^>]{0,400})>([^<]{0,200})</Item>");

    /** Straight line from a stored sample to a value, and who declares it; the unit may be no unit of length. */
    record Calibration(double offset, double factor, String unit, String source) {
        /** Returns what was done to the samples; empty if nothing was. */
        String note() {
            return factor == 1 && offset == 0
                    ? ""
                    : "heights are " + Decimals.format(factor) + " times the stored samples plus "
                            + Decimals.format(offset) + ", as " + source + " declares";
        }
    }

    static TiffScale of(TiffPage first) {
        String text = first.text(TIFF.TAG_IMAGE_DESCRIPTION);
        Matcher pixels = OME_PIXELS.matcher(text);
        return new TiffScale(
                text.startsWith("ImageJ="),
                Header.of(text, '='),
                pixels.find() ? Optional.of(pixels.group(1)) : Optional.empty());
    }

    private Optional<String> attribute(String name) {
        return attribute(pixels.orElse(""), name);
    }

    private static Optional<String> attribute(String attributes, String name) {
        Matcher value = Pattern.compile("\\b" + name + "\\s*=\\s*[\"']([^\"']{0,40})[\"']")
                .matcher(attributes);
        return value.find() ? Optional.of(value.group(1)) : Optional.empty();
    }

    /** Returns the size; only the ratio of the pitches if it is all that is stated. Resolutions of printers count as a ratio. */
    Extent extent(TiffPage page, Samples samples) {
        Optional<Header.Quantity> omeX = omePitch("X");
        if (omeX.isPresent() && omeX.get().value() > 0) {
            Header.Quantity x = omeX.get();
            return ofPitches(x, omePitch("Y").filter(y -> y.value() > 0).orElse(x), samples);
        }
        double perUnitX = page.number(TIFF.TAG_X_RESOLUTION, 0);
        double perUnitY = page.number(TIFF.TAG_Y_RESOLUTION, perUnitX);
        boolean resolved = perUnitX > 0 && perUnitY > 0;
        if (isImageJ && resolved) {
            String unit = unit("unit", "");
            return ofPitches(
                    new Header.Quantity(1 / perUnitX, unit),
                    new Header.Quantity(1 / perUnitY, unit("yunit", unit)),
                    samples);
        }
        double[] pitches = page.numbers(GEOGRAPHIC_PITCHES);
        if (pitches.length > 1 && pitches[0] > 0 && pitches[1] > 0) {
            return Extent.ofPitches(pitches[0], pitches[1], "", samples);
        }
        return resolved ? Extent.ofPitches(1 / perUnitX, 1 / perUnitY, "", samples) : Extent.UNKNOWN;
    }

    private static Extent ofPitches(Header.Quantity x, Header.Quantity y, Samples samples) {
        Optional<Double> perX = Extent.metersPer(x.unit());
        Optional<Double> perY = Extent.metersPer(y.unit());
        boolean comparable = x.unit().equals(y.unit()) || (perX.isPresent() && perY.isPresent());
        ScanException.refuseIf(
                !comparable,
                "has pixels in \"" + x.unit() + "\" along x and in \"" + y.unit()
                        + "\" along y; export it with one unit");
        double ratio = perX.isPresent() ? perY.orElseThrow() / perX.get() : 1;
        return Extent.ofPitches(x.value(), y.value() * ratio, x.unit(), samples);
    }

    private Optional<Header.Quantity> omePitch(String axis) {
        String unit = withMicro(attribute("PhysicalSize" + axis + "Unit").orElse("um"));
        return attribute("PhysicalSize" + axis)
                .flatMap(Header.Quantity::of)
                .map(size -> new Header.Quantity(size.value(), unit));
    }

    private static String withMicro(String unit) {
        return unit.replaceAll("(?i)&#(181|xB5);", "u");
    }

    private String unit(String key, String otherwise) {
        return description.text(key, otherwise).replace("\\u00B5", "u");
    }

    /** Returns GDAL's or ImageJ's calibration of samples, if there is one; throws ScanException if it is no straight line. */
    Optional<Calibration> calibration(TiffPage page) {
        return gdal(page).or(() -> imageJ(page.isFloat()));
    }

    /** Returns GDAL's scale, offset and unit of the first band, if there is one of them. */
    static Optional<Calibration> gdal(TiffPage page) {
        Header declared = new Header();
        Matcher item = GDAL_ITEM.matcher(page.text(GDAL_METADATA));
        while (item.find()) {
            boolean ofFirst = attribute(item.group(1), "sample").orElse("0").equals("0");
            attribute(item.group(1), "role")
                    .filter(role -> ofFirst)
                    .ifPresent(role -> declared.put(role.toLowerCase(Locale.ROOT), item.group(2)));
        }
        boolean any = declared.has("scale") || declared.has("offset");
        return any || declared.find("unittype").isPresent()
                ? Optional.of(new Calibration(
                        declared.number("offset", 0),
                        declared.number("scale", 1),
                        withMicro(declared.text("unittype", "")),
                        "GDAL's metadata"))
                : Optional.empty();
    }

    private Optional<Calibration> imageJ(boolean isFloat) {
        String unit = isImageJ ? unit("vunit", "") : "";
        if (isFloat || !isImageJ || !description.has("cf")) {
            return Optional.of(new Calibration(0, 1, unit, ""))
                    .filter(same -> isFloat && Extent.metersPer(unit).isPresent());
        }
        int function = (int) description.number("cf");
        ScanException.refuseIf(
                function != STRAIGHT_LINE && function != NONE && function != NONE_OPTICAL_DENSITY,
                "has ImageJ's calibration function " + function
                        + ", and only a straight line (0) is read; convert it to 32 bits in ImageJ");
        boolean plain = function != STRAIGHT_LINE || unit.isEmpty() || unit.equalsIgnoreCase("gray value");
        return plain
                ? Optional.empty()
                : Optional.of(new Calibration(
                        description.number("c0", 0), description.number("c1", 1), unit, "ImageJ's calibration"));
    }
}
