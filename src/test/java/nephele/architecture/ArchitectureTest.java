package nephele.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.lang.ArchRule;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Order;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;

@TestInstance(TestInstance.Lifecycle.PER_CLASS)
@Execution(ExecutionMode.CONCURRENT)
@Order(1) // one of the longest
class ArchitectureTest {
    private final JavaClasses product = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .importPackages("nephele");

    static Stream<ArchRule> rules() {
        return Stream.concat(CodeRules.ALL.stream(), DeterminismRules.ALL.stream());
    }

    @ParameterizedTest
    @MethodSource("rules")
    void theProductKeepsTheRule(ArchRule rule) {
        rule.allowEmptyShould(true).check(product);
    }

    @ParameterizedTest
    @EnumSource
    void theSourcesKeepTheRule(SourceRules rule) throws IOException {
        List<String> violations = SourceFile.all().stream()
                .flatMap(file -> rule.violations(file).stream())
                .toList();
        assertEquals(List.of(), violations);
    }

    @Test
    void theRulesSeeTheWholeProduct() throws IOException {
        assertTrue(product.contain("nephele.engine.math.bvh.SpatialIndex"));
        assertTrue(product.contain("nephele.app.Main"));
        assertTrue(product.stream().noneMatch(type -> type.getPackageName().equals("nephele.architecture")));
        assertTrue(SourceFile.all().stream().anyMatch(file -> file.path().endsWith(".glsl")));
    }
}
