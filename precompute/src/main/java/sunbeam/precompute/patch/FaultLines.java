package sunbeam.precompute.patch;

import static sunbeam.precompute.patch.PatchSettings.CROP;
import static sunbeam.precompute.patch.PatchSettings.LEVEL;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import sunbeam.precompute.fault.ScanFault;
import sunbeam.precompute.fault.ScanFaults;
import sunbeam.precompute.prepare.HeightField;
import sunbeam.precompute.prepare.Levelling;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;

/** Faults of a scan for people, with the options that leave them out or take them away. */
final class FaultLines {
    static final FaultLines NONE = new FaultLines(List.of(), List.of());

    private final List<ScanFault> faults;
    private final List<String> remedies;

    private FaultLines(List<ScanFault> faults, List<String> remedies) {
        this.faults = faults;
        this.remedies = remedies;
    }

    /**
     * Those of a scan that stay.
     *
     * @param whole as it was measured
     * @param choices of {@link PatchSettings#PREPARING}
     * @param levelling that is done
     */
    static FaultLines of(HeightField whole, Choices choices, Levelling levelling) {
        boolean levelled = levelling == Levelling.ROWS || levelling == Levelling.MEDIAN_ROWS;
        List<ScanFault> faults = ScanFaults.in(whole, choices.find(CROP)).stream()
                .filter(fault -> !levelled || fault.levelling().isEmpty())
                .toList();
        List<String> remedies = faults.stream()
                .map(fault -> fault.part()
                        .map(part ->
                                named(choices, CROP, part.written(whole.pitchX(), whole.pitchY())) + " leaves them out")
                        .or(() -> fault.levelling().map(by -> named(choices, LEVEL, by.label()) + " takes that away")))
                .map(remedy -> remedy.orElse(""))
                .toList();
        return new FaultLines(faults, remedies);
    }

    private static String named(Choices choices, Setting<?> setting, String value) {
        return choices.origin(PatchSettings.PATCH).name(setting) + " " + value;
    }

    /** Each by itself. */
    List<PatchFault> each() {
        List<PatchFault> each = new ArrayList<>();
        for (int i = 0; i < faults.size(); i++) {
            ScanFault fault = faults.get(i);
            each.add(new PatchFault(fault.words(), remedies.get(i), fault.unmeasured()));
        }
        return each;
    }

    /** All in one line, each remedy once; empty where there is no fault. */
    Optional<String> together() {
        if (faults.isEmpty()) {
            return Optional.empty();
        }
        StringBuilder line = new StringBuilder("the scan has faults that change what is told of it: ");
        for (int i = 0; i < faults.size(); i++) {
            boolean last = i + 1 == faults.size();
            String remedy = remedies.get(i);
            line.append(faults.get(i).words())
                    .append(
                            remedy.isEmpty() || (!last && remedies.get(i + 1).equals(remedy))
                                    ? ""
                                    : " (" + remedy + ")")
                    .append(last ? "" : "; ");
        }
        return Optional.of(line.toString());
    }
}
