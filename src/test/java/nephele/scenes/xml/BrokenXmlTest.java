package nephele.scenes.xml;

import static java.nio.charset.StandardCharsets.ISO_8859_1;
import static java.nio.charset.StandardCharsets.UTF_16LE;
import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.List;
import java.util.Random;
import java.util.function.Supplier;
import java.util.stream.Stream;
import nephele.engine.model.ModelFileException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Files that cannot be shown give an error with place and reason; others are shown with warnings. Isolated, since a thread
 * that shares its core with another test's takes up to twice the processor time for the same work.
 */
@Isolated
@Execution(ExecutionMode.CONCURRENT)
class BrokenXmlTest {
    private static final String MODEL = "<models><model file='box_2_3.3d'/></models>";
    private static final long MOST_CPU_NANOSECONDS = 1_000_000_000;

    /** @param line 0 for none */
    record Broken(byte[] bytes, int line, String words) {
        Broken(String text, int line, String words) {
            this(text.getBytes(UTF_8), line, words);
        }

        @Override
        public String toString() {
            String text = new String(bytes, 0, Math.min(40, bytes.length), ISO_8859_1);
            return text.replaceAll("[^ -~]", "?") + " → " + words;
        }
    }

    static Stream<Broken> refused() {
        return Stream.of(
                new Broken("", 1, "no tag"),
                new Broken("   \n\n", 1, "no tag"),
                new Broken("nothing but words", 1, "no tag"),
                new Broken("\n<html><scene/></html>", 2, "'html'"),
                new Broken("\n\n<group>" + MODEL + "</group>", 3, "begin with <scene> or <world>"),
                new Broken("</scene>", 1, "no scene"),
                new Broken("<scene>\n</scene>", 1, "no model"),
                new Broken("<world/>", 1, "no model"),
                new Broken("<scene>\n\n<modles/></scene>", 3, "did you mean 'models'?"),
                new Broken("<scene><models>\n<model fiel='a.3d'/></models></scene>", 2, "did you mean 'file'"),
                new Broken(
                        "<world>\n<windw/>\n<group>\n<models>\n<model hue='1'>\n</models></group></world>",
                        5,
                        "<model>: it names no file"),
                new Broken("<world><windw/>\n<model file='a.3d'/></world>", 2, "<model> does not belong"),
                new Broken("<scene><group><sclae/>\n<model fiel='a.3d'/></group></scene>", 2, "did you mean 'file'"),
                new Broken("<scene><group><sclae/>\n<modell file='a'/></group></scene>", 2, "did you mean 'model'"),
                new Broken("<scene>\n" + MODEL + "<group", 2, "ends inside <group"),
                new Broken("<scene>\n" + MODEL + "\n<model file='a", 3, "ends inside <model"),
                new Broken("<scene>" + MODEL + "\n<!-- and so on", 2, "a comment begins here"),
                new Broken("<scene>" + MODEL + "\n\n<![CDATA[ x", 3, "never ends"),
                new Broken("<?xml version='1.0'\n<scene>" + MODEL, 1, "an instruction begins here"),
                new Broken("\n<!DOCTYPE scene SYSTEM 'http://example.org/x.dtd'><scene/>", 2, "document types"),
                new Broken(
                        "<?xml version='1.0'?>\n"
                                + "<!DOCTYPE lolz [<!ENTITY a 'ha'><!ENTITY b '&a;&a;&a;'>]><scene>&b;</scene>",
                        2,
                        "entities are not read"),
                new Broken(
                        "<!DOCTYPE s [<!ENTITY x SYSTEM 'file:///etc/passwd'>]><scene>&x;</scene>",
                        1,
                        "entities are not read"),
                new Broken("<scene>\n<!ENTITY x 'y'>" + MODEL + "</scene>", 2, "entities are not read"),
                new Broken(("<scene>\n<!-- ol\u00e1 -->" + MODEL + "</scene>").getBytes(ISO_8859_1), 2, "not UTF-8"),
                new Broken(("<scene>" + MODEL + "</scene>\n\u00e9").getBytes(ISO_8859_1), 2, "not UTF-8"),
                new Broken(("<scene>" + MODEL + "</scene>").getBytes(UTF_16LE), 1, "UTF-16"),
                new Broken("<scene>\n" + MODEL + "\n\0</scene>", 3, "zero bytes"),
                new Broken(new byte[4096], 1, "zero bytes"),
                new Broken("<scene>" + "\n<group>".repeat(10_001) + MODEL, 10_002, "nested deeper"),
                new Broken("<scene>\n<group " + "a='1' ".repeat(1000) + ">" + MODEL, 2, "more than 100 values"),
                new Broken("<scene>" + "\n<group/>".repeat(500_000) + MODEL, 500_001, "more than 500000 tags"),
                new Broken(new byte[XmlSceneFile.MOST_BYTES + 1], 0, "more than 8 MiB"));
    }

    /** Measures the CPU time of this thread, independent of other load. */
    private static <T> T soon(Supplier<T> work) {
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        long start = clock.getCurrentThreadCpuTime();
        T result = work.get();
        assertTrue(clock.getCurrentThreadCpuTime() - start <= MOST_CPU_NANOSECONDS, "it took too long");
        return result;
    }

    @ParameterizedTest
    @MethodSource("refused")
    void whatCannotBeShownIsRefusedByFileAndLine(Broken broken) {
        ModelFileException problem =
                soon(() -> assertThrows(ModelFileException.class, () -> XmlSceneFile.read("a/b.xml", broken.bytes)));
        assertEquals(broken.line, problem.line(), problem.getMessage());
        assertTrue(problem.getMessage().startsWith(broken.line > 0 ? "a/b.xml:" + broken.line + ": " : "a/b.xml: "));
        assertTrue(problem.getMessage().contains(broken.words), problem.getMessage());
    }

    static Stream<Broken> odd() {
        String open = "<scene><group>\n";
        String close = MODEL + "</group></scene>";
        String worldOpen = "<world>\n";
        String worldClose = "<group>" + MODEL + "</group></world>";
        return Stream.of(
                new Broken(open + "<translate x='1'/><translate x='2'/>" + close, 2, "at most one"),
                new Broken(open + "<translat x='1'/>" + close, 2, "did you mean 'translate'"),
                new Broken(open + "<zzz>" + close, 2, "<zzz> is unknown"),
                new Broken(open + "<rotate angel='1' axisX='1'/>" + close, 2, "did you mean 'angle'"),
                new Broken(open + "<rotate angle='90'/>" + close, 2, "no direction"),
                new Broken(open + "<rotate axisX='1'/>" + close, 2, "neither angle nor time"),
                new Broken(open + "<translate x='NaN'/>" + close, 2, "'NaN' is no number"),
                new Broken(open + "<translate x='Infinity'/>" + close, 2, "is no number"),
                new Broken(open + "<translate x='1e999'/>" + close, 2, "beyond 1e9"),
                new Broken(open + "<translate x='1,5'/>" + close, 2, "'1,5' is no number"),
                new Broken(open + "<translate x=''/>" + close, 2, "is no number"),
                new Broken(open + "<translate x='" + "9".repeat(100_000) + "'/>" + close, 2, "is no number"),
                new Broken(open + "<translate x/>" + close, 2, "has no value"),
                new Broken(open + "<translate x='1' x='2'/>" + close, 2, "twice"),
                new Broken(open + "<translate x='1', y='2'/>" + close, 2, "stray ','"),
                new Broken(open + "<translate x=1/>" + close, 2, "without quotes: x"),
                new Broken(open + "<translate x='1>" + close, 2, "without quotes: x"),
                new Broken(open + "<translate x='1'" + close, 2, "has no '>'"),
                new Broken(open + "<translate x='&bogus;1'/>" + close, 2, "no known entity"),
                new Broken(open + "<translate time='3'/>" + close, 2, "no <point>"),
                new Broken(open + "<translate time='0'><point x='1'/></translate>" + close, 2, "it stands"),
                new Broken(open + "<translate time='3'><point x='1'/></translate>" + close, 2, "four points"),
                new Broken(open + "<scale x='2' y='2'/>" + close, 2, "z is 0"),
                new Broken(open + "<group>" + MODEL + close, 1, "<group> is not closed"),
                new Broken(open + "</models>" + close, 2, "closes nothing"),
                new Broken(open + "words < 5" + close, 2, "text means nothing"),
                new Broken(open + "<models><model/></models>" + close, 2, "names no file"),
                new Broken(
                        open + "<models><model file='a' diffR='2'/></models>" + close,
                        2,
                        "2 is not within 0 to 1: taken as 1"),
                new Broken(open + "<lights><light type='sun'/></lights>" + close, 2, "'sun' is unknown"),
                new Broken(open + "<lights><light/></lights>" + close, 2, "no type"),
                new Broken(open + "<lights><light type='directional'/></lights>" + close, 2, "no length"),
                new Broken(open + "<lights><light type='spot' cutoff='120'/></lights>" + close, 2, "taken as 90"),
                new Broken("<scene>" + MODEL + "</scene>\n<scene>" + MODEL + "</scene>", 2, "has ended"),
                new Broken("<scene>\n" + MODEL, 1, "<scene> is not closed"),
                new Broken(worldOpen + "<light type='point'/>" + worldClose, 2, "does not belong in <world>"),
                new Broken(
                        "<world><group><models><model file='a'>\n<colour>\n<diffuse R='1'/></colour></model></models>"
                                + "</group></world>",
                        3,
                        "<diffuse> does not belong in <model>"),
                new Broken(
                        worldOpen + "<lights>" + "<light type='point'/>".repeat(9) + "</lights>" + worldClose,
                        2,
                        "8 lights at most"),
                new Broken(worldOpen + "<window width='0' height='9'/>" + worldClose, 2, "not within"),
                new Broken(worldOpen + "<camera><projection fov='180'/></camera>" + worldClose, 2, "taken as 170"),
                new Broken(
                        worldOpen + "<camera><projection near='5' far='5'/></camera>" + worldClose, 2, "beyond near"),
                new Broken(worldOpen + "<camera><position x='0'/></camera>" + worldClose, 2, "where it stands"),
                new Broken(worldOpen + "<camera><up x='5' y='5' z='5'/></camera>" + worldClose, 2, "along its sight"),
                new Broken(worldOpen + "<camera/><camera/>" + worldClose, 2, "twice"));
    }

    @ParameterizedTest
    @MethodSource("odd")
    void whatIsOddIsToldByLineAndTheRestIsShown(Broken broken) {
        XmlScene scene = soon(() -> XmlSceneFile.read("b.xml", broken.bytes));
        assertTrue(
                scene.warnings().stream()
                        .anyMatch(warning -> warning.line() == broken.line
                                && warning.message().contains(broken.words)),
                () -> scene.warnings().toString());
        PosedScene posed = PosedScene.of(scene);
        assertTrue(posed.modelCount() >= 1);
        posed.at(1.5);
        assertTrue(posed.worldFromModel(0).isFinite());
    }

    @Test
    void tenThousandNestedGroupsAreRead() {
        String text = "<scene>" + "<group><translate x='1'/>".repeat(10_000) + MODEL + "</group>".repeat(10_000);
        XmlScene scene = soon(() -> XmlSceneFile.read("b.xml", (text + "</scene>").getBytes(UTF_8)));
        assertEquals(List.of(), scene.warnings());
        assertEquals(10_000, PosedScene.of(scene).worldFromModel(0).m30());
        assertEquals(scene, XmlSceneFile.read("b.xml", (text + "</scene>").getBytes(UTF_8)));
    }

    /** The largest files with a warning at every letter give a thousand warnings, and memory for no more. */
    @ParameterizedTest
    @ValueSource(strings = {"<zz a=1 bc=2 cd=3 de=4 ef='5'/>", "words < ", "</x>", "\n<!-- -->", "<group x=&x;>"})
    void oddFromEndToEndItIsStillReadSoon(String odd) {
        String text = "<scene>" + MODEL + odd.repeat((XmlSceneFile.MOST_BYTES - 100) / odd.length()) + "</scene>";
        boolean told = soon(() -> {
            try {
                return XmlSceneFile.read("b.xml", text.getBytes(UTF_8))
                                .warnings()
                                .size()
                        <= 1001;
            } catch (ModelFileException refused) {
                return refused.line() > 0;
            }
        });
        assertTrue(told);
    }

    /** Truncated, cut, doubled and bit-flipped files give a scene or a refusal, and no other exception. */
    @Test
    void damagedAnywhereItNeverFallsOver() {
        String whole = "<?xml version='1.0'?>\n"
                + "<world><window width='1' height='2'/><camera><up x='1' y='0' z='0'/></camera><!-- c"
                + " --><lights><light type='point' posx='1'/></lights>\n"
                + "<group><transform><rotate time='4' y='1'/><translate time='3' align='true'><point x='1'/><point"
                + " x='2'/><point/><point y='1'/></translate></transform><models><model file='a&amp;b.3d'><texture"
                + " file=t.png/>\n"
                + "<color><diffuse"
                + " R='1'/></color></model></models>"
                + "<group>" + MODEL + "</group></group></world>";
        Random random = new Random(99);
        int shown = 0;
        for (int i = 0; i < 3000; i++) {
            byte[] bytes = damaged(whole.getBytes(UTF_8), random);
            try {
                PosedScene.of(XmlSceneFile.read("b.xml", bytes)).at(2);
                shown++;
            } catch (ModelFileException refused) {
                assertTrue(refused.line() > 0, refused.getMessage());
            }
        }
        assertTrue(shown > 1000, "shown: " + shown);
    }

    private static byte[] damaged(byte[] whole, Random random) {
        int at = random.nextInt(whole.length);
        int end = at + random.nextInt(whole.length - at);
        byte[] damaged = random.nextBoolean() ? whole.clone() : java.util.Arrays.copyOf(whole, at);
        if (damaged.length == whole.length) {
            byte[] signs = "<>/='\" &x\n".getBytes(UTF_8);
            for (int k = random.nextInt(4); k >= 0; k--) {
                damaged[random.nextInt(whole.length)] = signs[random.nextInt(signs.length)];
            }
        } else if (random.nextBoolean()) {
            damaged = java.util.Arrays.copyOf(damaged, at + whole.length - end);
            System.arraycopy(whole, end, damaged, at, whole.length - end);
        }
        return damaged;
    }
}
