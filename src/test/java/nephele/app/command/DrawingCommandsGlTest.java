package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import nephele.engine.level.ToneCurve;
import nephele.engine.level.appearance.AutoExposure;
import nephele.engine.level.appearance.LuminanceHistogram;
import nephele.engine.render.frame.QualityField;
import nephele.engine.render.frame.ToneMapping;
import nephele.host.draw.QualityChoice;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The contract of `render`, and the usage that `bench` and `play` reject. */
class DrawingCommandsGlTest {
    private static final String SKY =
            "{\"format\": \"nephele-level\", \"version\": 1, \"environment\": {\"sky\": {\"kind\": \"constant\","
                    + " \"radiance\": [0.25, 0.5, 2]}, \"exposureStops\": 1}, \"player\": {\"feet\": [0, 0, 0]}}";

    @TempDir
    Path folder;

    private String level() throws IOException {
        return Files.writeString(folder.resolve("sky.json"), SKY).toString();
    }

    /** Makes an empty folder with the name of a picture. */
    private String taken() throws IOException {
        return Files.createDirectories(folder.resolve("taken.png")).toString();
    }

    @Test
    void aPngHasTheSizeAskedForAndShowsTheSkyDeveloped() throws IOException {
        var file = folder.resolve("new/folder/picture.png");
        var answer = Captured.run("render", level(), "--out", file.toString(), "--size", "40x30", "--frames", "2");
        assertEquals(0, answer.exitCode(), answer.err());
        var picture = ImageIO.read(file.toFile());
        assertEquals(40, picture.getWidth());
        assertEquals(30, picture.getHeight());
        int rgb = picture.getRGB(20, 15);
        assertEquals(188, rgb >> 16 & 255, 1);
        assertEquals(255, rgb >> 8 & 255);
    }

    @Test
    void aPfmHoldsRadianceBeforeExposureWithTheBottomRowFirst() throws IOException {
        var file = folder.resolve("picture.pfm");
        var answer = Captured.run("render", level(), "--out", file.toString(), "--size", "5x3");
        assertEquals(0, answer.exitCode(), answer.err());
        byte[] bytes = Files.readAllBytes(file);
        var header = "PF\n5 3\n-1.0\n".getBytes(StandardCharsets.US_ASCII);
        assertEquals(header.length + 5 * 3 * 12, bytes.length);
        var pixels = ByteBuffer.wrap(bytes, header.length, 12).order(ByteOrder.LITTLE_ENDIAN);
        assertEquals(0.25f, pixels.getFloat());
        assertEquals(0.5f, pixels.getFloat());
        assertEquals(2f, pixels.getFloat());
    }

    /** A PNG, drawn or traced, shows the converged exposure; a PFM has the light itself. */
    @Test
    void exposureAutoIsConvergedInAPngAndBypassedByAPfm() throws IOException {
        var auto = SKY.replace("\"exposureStops\": 1", "\"exposureStops\": \"auto\"");
        var level = Files.writeString(folder.resolve("auto.json"), auto).toString();
        var png = folder.resolve("auto.png");
        var traced = folder.resolve("traced.png");
        var pfm = folder.resolve("auto.pfm");
        var fixed = folder.resolve("fixed.pfm");
        var direct = folder.resolve("direct.png");
        assertEquals(
                "",
                Captured.run("render", level, "--out", png.toString(), "--size", "8x8")
                        .err());
        Captured.run("render", level, "--out", traced.toString(), "--size", "8x8", "--reference", "--spp", "1");
        Captured.run("render", level, "--out", pfm.toString(), "--size", "8x8");
        Captured.run("render", level(), "--out", fixed.toString(), "--size", "8x8");
        double luminance = 0.2126 * 0.25 + 0.7152 * 0.5 + 0.0722 * 2;
        float[] even = {(float) luminance, (float) luminance, (float) luminance};
        double factor = Math.pow(2, AutoExposure.stops(LuminanceHistogram.of(even, 1), 0));
        double green = 255 * ToneMapping.displayValue(0.5, factor, ToneCurve.CLIP);
        assertEquals(green, ImageIO.read(png.toFile()).getRGB(4, 4) >> 8 & 255, 1);
        assertEquals(green, ImageIO.read(traced.toFile()).getRGB(4, 4) >> 8 & 255, 1);
        assertArrayEquals(Files.readAllBytes(fixed), Files.readAllBytes(pfm));
        var notice = Captured.run("render", level, "--out", direct.toString(), "--size", "8x8", "--output", "direct");
        assertTrue(notice.err().contains("exposureStops \"auto\" counts as 0"), notice.err());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "render LEVEL|2|--out",
                "render LEVEL --out a.jpg|2|.png or .pfm",
                "render LEVEL --out a.png --size 0x5|2|--size",
                "render LEVEL --out a.png --size big|2|--size",
                "render LEVEL --out a.png --camera none|1|there is no camera `none`",
                "render LEVEL --out a.png --eye 0,0,0|2|--target",
                "render LEVEL --out a.png --eye 0,0,0 --target 0,0,0|2|same point",
                "render LEVEL --out a.png --eye 0,0,NaN --target 0,0,0|2|--eye",
                "render LEVEL --out a.png --fov 60|2|--eye",
                "render LEVEL --out a.png --eye 0,0,0 --target 0,0,1 --fov 171|2|170",
                "render LEVEL --out a.png --quality best|2|--quality",
                "render LEVEL --out a.png --set colour=red|2|anisotropy",
                "render LEVEL --out a.png --set anisotropy|2|key=value",
                "render LEVEL --out a.png --set anisotropy=1 anisotropy=2|2|twice",
                "render LEVEL --out a.pfm --output plain|2|linear radiance",
                "render LEVEL --out a.png --frames 0|2|--frames",
                "render LEVEL --out a.png --time -1|2|--time",
                "render LEVEL --out a.png --output bright|2|none of direct, hdr, plain",
                "render LEVEL --out a.png --technique paint|2|none of auto, skybox,",
                "render UNTEXTURED --out a.png|1|untextured.json: materials[0].texture: textures/none.png",
                "bench UNTEXTURED --frames 1 --size 8x8|1|untextured.json: materials[0].texture: textures/none.png",
                "render LEVEL --out a.png --spp 4|2|--reference",
                "render LEVEL --out a.png --seed 4|2|--reference",
                "render LEVEL --out a.png --reference --spp 0|2|--spp",
                "render UNTEXTURED --out a.png --reference|1|untextured.json: materials[0].texture: textures/none.png",
                "render LEVEL --out /dev/null/a.png|3|a.png: can't be written",
                "render LEVEL --out FOLDER --size 8x8|3|it is a folder",
                "render nowhere.json --out a.png|1|nowhere.json",
                "bench|2|--calibrate",
                "bench LEVEL --calibrate|2|--calibrate",
                "bench LEVEL --bare --per-pass|2|--per-pass",
                "bench LEVEL LEVEL|2|--every-camera",
                "bench LEVEL --every-camera --frames 3|2|--every-camera",
                "bench LEVEL --frames 0|2|--frames",
                "play LEVEL --from 1,2,3|2|x,y,z,yawDeg,pitchDeg",
                "play LEVEL --ticks-per-second 60|2|--record",
                "play LEVEL --record r.json --ticks-per-second 5|2|--ticks-per-second is a whole number from 10 to"
                        + " 1000",
                "play LEVEL --replay nowhere.json|1|nowhere.json"
            })
    void whatIsWrongIsNamed(String line, int exitCode, String named) throws IOException {
        var answer = Captured.run(line.replace("LEVEL", level())
                .replace("UNTEXTURED", untextured())
                .replace("FOLDER", taken())
                .split(" "));
        assertAll(
                () -> assertEquals(exitCode, answer.exitCode(), answer.err()),
                () -> assertTrue(answer.err().contains(named), answer.err()),
                () -> assertEquals("", answer.out()));
    }

    private String untextured() throws IOException {
        var text = SKY.substring(0, SKY.length() - 1)
                + ", \"materials\": [{\"id\": \"m\", \"texture\": \"textures/none.png\"}],"
                + " \"solids\": [{\"id\": \"s\", \"kind\": \"box\", \"material\": \"m\","
                + " \"centre\": [0, -1, 0], \"size\": [4, 1, 4]}]}";
        return Files.writeString(folder.resolve("untextured.json"), text).toString();
    }

    @Test
    void anOptionWithoutEffectIsToldOnce() throws IOException {
        var file = folder.resolve("picture.png").toString();
        var answer =
                Captured.run("render", level(), "--out", file, "--size", "8x8", "--time", "3", "--technique", "volume");
        assertEquals(0, answer.exitCode());
        assertEquals(
                "nothing in this level follows --time or --technique",
                answer.err().strip());
    }

    @Test
    void settingsMayStandBeforeTheLevel() throws IOException {
        var file = folder.resolve("picture.png").toString();
        var answer = Captured.run(
                "render", "--set", "anisotropy=2", "shadowTexels=64", level(), "--out", file, "--size", "8x8");
        assertEquals(0, answer.exitCode(), answer.err());
    }

    @Test
    void playRefusesAReplayOfAnotherLevel() throws IOException {
        var replay = folder.resolve("replay.json");
        Files.writeString(
                replay,
                "{\"format\": \"nephele-replay\", \"version\": 1, \"level\": \"a\", \"levelName\": \"There\","
                        + " \"inputs\": []}");
        var answer = Captured.run("play", level(), "--replay", replay.toString());
        assertEquals(1, answer.exitCode());
        assertTrue(answer.err().startsWith(replay + ": levelName: was recorded in the level 'There'"), answer.err());
    }

    /** The help names every setting, so that each can be found. */
    @Test
    void theHelpNamesEverySetting() {
        String help = Captured.run("render", "--help").out().replaceAll("\\s+", " ");
        for (QualityField field : QualityChoice.FIELDS) {
            assertTrue(help.contains(field.name() + ",") || help.contains(field.name() + ";"), field.name());
        }
    }
}
