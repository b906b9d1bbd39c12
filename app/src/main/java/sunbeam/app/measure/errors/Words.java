package sunbeam.app.measure.errors;

import java.util.ArrayList;
import java.util.List;
import sunbeam.precompute.setting.Sentence;
import sunbeam.precompute.setting.Setting;

/** What to do, put together: "leave out --terms and --radius, and give --tolerance 1e-4". */
final class Words {
    private final List<Object> parts = new ArrayList<>();

    Words() {}

    /** To go on from. */
    Words(Sentence begun) {
        parts.addAll(begun.parts());
    }

    Words leaveOut(List<Setting<?>> settings) {
        for (int i = 0; i < settings.size(); i++) {
            String last = i == settings.size() - 1 ? " and " : ", ";
            parts.add(i == 0 ? "leave out " : last);
            parts.add(settings.get(i));
        }
        return this;
    }

    Words give(Setting<?> setting, String value) {
        parts.add(parts.isEmpty() ? "give " : ", and give ");
        parts.add(setting);
        parts.add(" " + value);
        return this;
    }

    Sentence sentence() {
        return new Sentence(parts);
    }
}
