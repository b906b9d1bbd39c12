package sunbeam.app.scene;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.OptionalDouble;
import sunbeam.precompute.text.Quoted;
import sunbeam.precompute.units.Decimals;
import sunbeam.precompute.units.Lengths;

/** Quantities as scene files have them: texts with their units. */
final class SceneUnits {
    // Conversion between degrees and radians spoils the last ones.
    private static final int ANGLE_DIGITS = 12;

    private SceneUnits() {}

    /** An angle in degrees or radians to radians: {@code "30 deg"}, {@code "0.5 rad"}. */
    static double angle(String text) {
        String value = text.strip();
        boolean degrees = value.endsWith("deg");
        if (!degrees && !value.endsWith("rad")) {
            throw new IllegalArgumentException(
                    Quoted.of(text) + " is no angle with its unit; write it with deg or rad, such as 30 deg");
        }
        OptionalDouble number = Decimals.parse(value.substring(0, value.length() - 3));
        if (number.isEmpty()) {
            throw new IllegalArgumentException(Quoted.of(text) + " has no number; write it as in 30 deg");
        }
        return degrees ? Math.toRadians(number.getAsDouble()) : number.getAsDouble();
    }

    /** Radians as text, in degrees; {@link #angle} gives the same number back to twelve digits. */
    static String angleText(double radians) {
        BigDecimal degrees = new BigDecimal(Math.toDegrees(radians)).round(new MathContext(ANGLE_DIGITS));
        return number(degrees.doubleValue()) + " deg";
    }

    /** A coordinate to metres. */
    static double coordinate(String text) {
        double metres = Lengths.parse(text);
        if (!(Math.abs(metres) <= 1e6)) {
            throw new IllegalArgumentException(Quoted.of(text) + " is out of range; give at most 1000 km");
        }
        return metres;
    }

    /** Metres as text, exactly. */
    static String coordinateText(float metres) {
        return number(metres) + " m";
    }

    /** A number without a superfluous ".0". */
    static String number(double value) {
        // Values that were floats are shown with a float's digits.
        String text = (float) value == value ? Float.toString((float) value) : Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
