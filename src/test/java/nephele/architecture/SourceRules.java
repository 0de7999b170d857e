package nephele.architecture;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The rules that need the source text: constants are inlined, and comments and line counts are not compiled. */
enum SourceRules {
    AT_MOST_800_LINES {
        @Override
        List<String> violations(SourceFile file) {
            long lines = file.text().lines().count();
            return lines <= 800 ? List.of() : List.of(file.path() + ": " + lines + " lines; split it by topic");
        }
    },
    NOTHING_NEWER_THAN_OPENGL_4_1 {
        @Override
        List<String> violations(SourceFile file) {
            return file.matches(Pattern.compile("org\\.lwjgl\\.opengl\\.(?!" + FLOOR + "\\b)\\w+"));
        }
    },
    GLSL_410 {
        @Override
        List<String> violations(SourceFile file) {
            return file.matches(Pattern.compile("(?m)^\\s*#\\s*(version (?!410 core)|extension).*"));
        }
    },
    NO_UNFINISHED_WORK {
        @Override
        List<String> violations(SourceFile file) {
            return file.matches(Pattern.compile("\\b(TO" + "DO|FIX" + "ME|XX" + "X)\\b.*"));
        }
    },
    NO_SLEEPS_RETRIES_OR_DISABLED_TESTS {
        @Override
        List<String> violations(SourceFile file) {
            Pattern banned = Pattern.compile(
                    "Thread\\." + "sleep|TimeUnit\\.\\w+\\." + "sleep|@" + "Disabled|@" + "RepeatedTest");
            return file.isTest() ? file.matches(banned) : List.of();
        }
    },
    NO_STACK_TRACES_FOR_USERS {
        @Override
        List<String> violations(SourceFile file) {
            return file.isTest() ? List.of() : file.matches(Pattern.compile("\\.print" + "StackTrace\\(\\)"));
        }
    },
    TESTS_ARE_NAMED_BY_TIER {
        @Override
        List<String> violations(SourceFile file) {
            return file.isTest() ? tierViolations(file) : List.of();
        }
    },
    /** The tests of a class with this mode run on several threads, and an OpenGL context belongs to one. */
    CONCURRENT_TESTS_USE_NO_OPENGL {
        @Override
        List<String> violations(SourceFile file) {
            boolean isPure = !file.simpleName().matches(".*(Gl|Swing)Test");
            return isPure ? List.of() : file.matches(Pattern.compile("@Execution\\b.*CONCURRENT.*"));
        }
    },
    /** A change of the process would be visible to the tests on the other thread. */
    TESTS_THAT_CHANGE_THE_PROCESS_ARE_ISOLATED {
        @Override
        List<String> violations(SourceFile file) {
            boolean isIsolated = !file.isTest() || file.text().contains("@Iso" + "lated\n");
            Pattern change = Pattern.compile("(Locale|TimeZone)\\.set" + "Default\\("
                    + "|System\\.(set(Out|Err|In|Propert(y|ies))|clear" + "Property)\\(");
            return isIsolated ? List.of() : file.matches(change);
        }
    };

    /**
     * The permitted LWJGL classes: the core profile up to 4.1, context creation, and the debug callback behind
     * its check.
     */
    private static final String FLOOR = "(GL[123]\\dC?|GL4[01]C?|GL|GLCapabilities|KHRDebug|GLDebugMessageCallback)";

    abstract List<String> violations(SourceFile file);

    private static List<String> tierViolations(SourceFile file) {
        String name = file.simpleName();
        boolean holdsTests = !file.matches(Pattern.compile("@(Test|ParameterizedTest|TestFactory)\\b"))
                .isEmpty();
        if (!holdsTests) {
            return name.endsWith("Test") ? List.of(file.path() + ": holds no test") : List.of();
        }
        List<String> wrong = new ArrayList<>();
        if (!name.endsWith("Test")) {
            wrong.add(file.path() + ": only names that end in Test are run");
        }
        Matcher gl = Pattern.compile("\\b(OffscreenContext|GlContext|OffscreenCanvas)\\b")
                .matcher(file.text());
        if (gl.find() && !name.endsWith("GlTest") && !file.path().contains("/architecture/")) {
            wrong.add(file.path() + ": uses OpenGL, so its name must end in GlTest");
        }
        Matcher swing = Pattern.compile("import javax\\.swing|new Frame\\(|GameWindow\\.open")
                .matcher(file.text());
        if (swing.find() && !name.endsWith("SwingTest")) {
            wrong.add(file.path() + ": opens windows, so its name must end in SwingTest");
        }
        if (name.endsWith("SwingTest") && !file.text().contains("@Execution(ExecutionMode.SAME_THREAD)")) {
            wrong.add(file.path() + ": shares Swing's event thread, so it must be marked SAME_THREAD");
        }
        return wrong;
    }
}
