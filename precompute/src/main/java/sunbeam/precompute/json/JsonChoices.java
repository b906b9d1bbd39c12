package sunbeam.precompute.json;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;
import sunbeam.precompute.units.Decimals;

/** Writes choices so that {@link JsonObject#choices} reads them again. */
public final class JsonChoices {
    private JsonChoices() {}

    /** Writes all that was chosen as keys of the object that is being written. */
    public static void write(JsonGenerator json, Choices choices) throws IOException {
        for (Setting<?> setting : choices.chosen()) {
            String value = choices.written(setting);
            json.writeFieldName(setting.fileKey());
            if (setting.kind().form() == ValueKind.Form.FLAG) {
                json.writeBoolean(Boolean.parseBoolean(value));
            } else if (setting.kind().form() == ValueKind.Form.NUMBER
                    && Decimals.parse(value).isPresent()) {
                json.writeNumber(value);
            } else {
                json.writeString(value);
            }
        }
    }
}
