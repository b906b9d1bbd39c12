package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.HEIGHT_UNIT;
import static sunbeam.precompute.patch.PatchSettings.MAX_HEIGHT;
import static sunbeam.precompute.patch.PatchSettings.WIDTH;

import java.nio.file.Path;
import java.util.Optional;
import sunbeam.precompute.scan.LengthUnit;
import sunbeam.precompute.scan.ScanChannel;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.SettingException;
import sunbeam.precompute.units.Lengths;

/**
 * Scale of a channel: the file's values, completed by the user's choices, which may repeat them but not contradict them.
 *
 * @param metersPerUnit meters per unit of the samples
 * @param pitchX distance between columns, meters
 * @param heightsFrom setting that gave {@code metersPerUnit}; empty if the file did
 */
record FileScale(double metersPerUnit, double pitchX, double pitchY, Optional<Setting<?>> heightsFrom) {
    /** Users copy lengths from messages, which have six digits. */
    private static final double SAME = 1e-5;

    /** @throws SettingException if a choice contradicts the file, is absurd or is missing */
    static FileScale of(Path file, ScanChannel channel, Choices choices) {
        Optional<Double> width = agreed(WIDTH, channel.extent().width(), choices, file);
        Optional<Double> height = agreed(HEIGHT, channel.extent().height(), choices, file);
        Optional<Double> chosen = choices.find(HEIGHT_UNIT).flatMap(LengthUnit::meters);
        Optional<Double> unit = agreed(HEIGHT_UNIT, channel.metersPerUnit(), chosen, file);
        Optional<Double> fullScale = agreed(MAX_HEIGHT, channel.metersPerUnit(), choices, file);
        boolean fromFullScale = channel.unit().equals(ScanChannel.FULL_SCALE);
        requireOne(choices, fromFullScale);
        Optional<Double> metersPerUnit = unit.or(() -> fullScale);
        if (width.isEmpty() || metersPerUnit.isEmpty()) {
            throw missing(file, width.isEmpty(), metersPerUnit.isEmpty(), fromFullScale);
        }
        double pitchX = width.get() / channel.columns();
        double pitchY = height.map(side -> side / channel.rows())
                .orElse(pitchX * channel.extent().aspect());
        boolean own = channel.extent().width().isPresent();
        Plausibility.requireSides(pitchX * channel.columns(), pitchY * channel.rows(), file, own);
        if (fromFullScale && metersPerUnit.get() > Plausibility.LARGEST_RELIEF) {
            throw new SettingException(
                    MAX_HEIGHT,
                    "is absurd for the full scale of whole numbers; the most is "
                            + Lengths.format(Plausibility.LARGEST_RELIEF) + " (is the unit right?)");
        }
        Setting<?> from = choices.has(HEIGHT_UNIT) ? HEIGHT_UNIT : MAX_HEIGHT;
        return new FileScale(
                metersPerUnit.get(),
                pitchX,
                pitchY,
                channel.metersPerUnit().isPresent() ? Optional.empty() : Optional.of(from));
    }

    private static Optional<Double> agreed(
            Setting<Double> setting, Optional<Double> known, Choices choices, Path file) {
        return agreed(setting, known, choices.find(setting), file);
    }

    private static Optional<Double> agreed(
            Setting<?> setting, Optional<Double> known, Optional<Double> chosen, Path file) {
        if (known.isPresent() && chosen.isPresent() && Math.abs(chosen.get() - known.get()) > SAME * known.get()) {
            throw new SettingException(
                    setting,
                    "contradicts " + file + ", which says " + Lengths.format(known.get()) + " itself; leave it out");
        }
        return known.or(() -> chosen);
    }

    private static void requireOne(Choices choices, boolean fromFullScale) {
        if (choices.has(MAX_HEIGHT) && choices.has(HEIGHT_UNIT)) {
            throw new SettingException(HEIGHT_UNIT, "contradicts ", MAX_HEIGHT, "; give one of them");
        }
        if (fromFullScale && choices.has(HEIGHT_UNIT)) {
            throw new SettingException(
                    HEIGHT_UNIT,
                    "is for numbers without unit; of an image's whole numbers give the height of full scale with ",
                    MAX_HEIGHT);
        }
    }

    private static SettingException missing(Path file, boolean width, boolean unit, boolean fromFullScale) {
        Setting<?> ofHeights = fromFullScale ? MAX_HEIGHT : HEIGHT_UNIT;
        String lacks = fromFullScale
                ? " is an image without scale"
                : " does not say "
                        + (width ? "how large the scan is" + (unit ? " nor " : "") : "")
                        + (unit ? "in which unit its heights are" : "");
        String what = "is missing: " + file + lacks + "; add for example ";
        String heights = (fromFullScale ? " 375nm" : " nm") + (fromFullScale ? ", or name a descriptor (.json)" : "");
        String sides = fromFullScale ? " 65um" : " 20um";
        if (!width) {
            return new SettingException(ofHeights, what, ofHeights, heights);
        }
        return unit
                ? new SettingException(WIDTH, what, WIDTH, sides + " and ", ofHeights, heights)
                : new SettingException(WIDTH, what, WIDTH, sides);
    }
}
