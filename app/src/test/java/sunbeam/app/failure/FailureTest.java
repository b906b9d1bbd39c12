package sunbeam.app.failure;

import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import java.util.List;
import org.junit.jupiter.api.Test;
import sunbeam.app.terminal.ExitCode;

final class FailureTest {
    /** An exception without an entry would be reported as a bug. */
    @Test
    void everyExceptionOfOursHasAMeaning() {
        List<JavaClass> exceptions = new ClassFileImporter()
                        .withImportOption(ImportOption.Predefined.DO_NOT_INCLUDE_TESTS)
                        .importPackages("sunbeam", "jrtr")
                        .stream()
                        .filter(type -> type.isAssignableTo(Throwable.class))
                        .toList();
        assertThat(exceptions).extracting(JavaClass::getSimpleName).contains("SettingException", "GraphicsException");
        for (JavaClass type : exceptions) {
            assertThat(Failure.codeOf(type.reflect())).as(type.getName()).isNotEqualTo(ExitCode.INTERNAL_ERROR);
        }
    }
}
