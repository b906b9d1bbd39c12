package sunbeam.app.cli;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.ISetter;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Spec;
import sunbeam.app.terminal.OptionOrigin;
import sunbeam.precompute.setting.Choices;
import sunbeam.precompute.setting.Setting;
import sunbeam.precompute.setting.ValueKind;

/** Command-line options for a list of settings; a picocli mixin. {@link #choices()} parses and checks the values. */
public class SettingOptions {
    private final List<Setting<?>> settings;
    private final boolean overriding;
    private final Map<Setting<?>, String> helpTexts;
    private final Map<Setting<?>, String> texts = new HashMap<>();

    public SettingOptions(List<Setting<?>> settings) {
        this(settings, Map.of());
    }

    /** Makes options with other texts of the help for defaults that the command itself applies. */
    public SettingOptions(List<Setting<?>> settings, Map<Setting<?>, String> helpTexts) {
        this(settings, false, helpTexts);
    }

    private SettingOptions(List<Setting<?>> settings, boolean overriding, Map<Setting<?>, String> helpTexts) {
        this.settings = List.copyOf(settings);
        this.overriding = overriding;
        this.helpTexts = Map.copyOf(helpTexts);
    }

    /** Returns options that override values from elsewhere, such as a scene; the help names only these defaults. */
    public static SettingOptions overriding(List<Setting<?>> settings, Map<Setting<?>, String> helpTexts) {
        return new SettingOptions(settings, true, helpTexts);
    }

    @Spec
    final void declare(CommandSpec own) {
        settings.forEach(setting -> own.addOption(option(setting)));
        declareArguments(own);
    }

    protected void declareArguments(CommandSpec own) {}

    private OptionSpec option(Setting<?> setting) {
        // picocli formats descriptions, so % is doubled.
        OptionSpec.Builder option = OptionSpec.builder(OptionOrigin.INSTANCE.name(setting))
                .userObject(setting)
                .description(description(setting).replace("%", "%%"))
                .setter(setter(text -> texts.put(setting, text)));
        return setting.kind().form() == ValueKind.Form.FLAG
                ? option.arity("0").negatable(true).type(Boolean.class).build()
                : option.paramLabel(setting.kind().placeholder())
                        .type(String.class)
                        .build();
    }

    /** Returns picocli's setter that passes the text of an option, or of the first argument, to a consumer. */
    protected static ISetter setter(Consumer<String> receiver) {
        return new ISetter() {
            @Override
            public <T> T set(T value) {
                Object first = value instanceof String[] many
                        ? Arrays.stream(many).findFirst().orElse(null)
                        : value;
                receiver.accept(first == null ? null : first.toString());
                return value;
            }
        };
    }

    private String description(Setting<?> setting) {
        Optional<String> standard = overriding ? Optional.empty() : setting.writtenStandard();
        return setting.help().in(OptionOrigin.INSTANCE)
                + Optional.ofNullable(helpTexts.get(setting))
                        .or(() -> standard)
                        .map(value -> " Default: " + value + ".")
                        .orElse("");
    }

    /** Returns the choices that the command line makes among these settings; throws a {@code SettingException} for invalid values. */
    public Choices choices() {
        Choices choices = Choices.at(OptionOrigin.INSTANCE);
        for (Setting<?> setting : settings) {
            String text = texts.get(setting);
            choices = text == null ? choices : choices.parsed(setting, text, OptionOrigin.INSTANCE);
        }
        return choices;
    }
}
