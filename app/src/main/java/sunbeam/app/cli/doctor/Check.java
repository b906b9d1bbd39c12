package sunbeam.app.cli.doctor;

import java.util.Optional;

/** Line of the doctor's report: name of a property of this machine, its value, and a remedy if the value prevents or limits rendering. */
record Check(String name, String value, Optional<String> remedy) {
    static Check ok(String name, String value) {
        return new Check(name, value, Optional.empty());
    }

    static Check failed(String name, String value, String remedy) {
        return new Check(name, value, Optional.of(remedy));
    }

    boolean isOk() {
        return remedy.isEmpty();
    }
}
