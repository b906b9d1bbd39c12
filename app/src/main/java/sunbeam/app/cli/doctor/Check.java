package sunbeam.app.cli.doctor;

import java.util.Optional;

/** One line of the doctor's report: what was looked at, what was found, and what to do about it unless all is well. */
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
