package nephele.app.command;

import static org.junit.jupiter.api.Assertions.assertAll;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import javax.imageio.ImageIO;
import nephele.engine.model.file.MeshText;
import nephele.engine.model.shape.ShapeKind;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The contract of `scene` without a window. */
class SceneCommandGlTest {
    private static final String BOX = "<world><window width=\"40\" height=\"30\"/>"
            + "<camera><position x=\"0\" y=\"0\" z=\"3\"/><lookAt x=\"0\" y=\"0\" z=\"0\"/></camera>\n"
            + "<group><transform><translate x=\"SHIFT\" y=\"0\" z=\"0\"/></transform><models><model file=\"MODEL\">"
            + "<color><diffuse R=\"0\" G=\"0\" B=\"0\"/><ambient R=\"200\" G=\"100\" B=\"0\"/>"
            + "<emissive R=\"0\" G=\"50\" B=\"0\"/></color></model></models></group></world>";

    @TempDir
    Path folder;

    private String scene(String name, String model, int shift) throws IOException {
        String xml = BOX.replace("MODEL", model).replace("SHIFT", String.valueOf(shift));
        return Files.writeString(folder.resolve(name), xml).toString();
    }

    private BufferedImage picture(String... arguments) throws IOException {
        Path out = folder.resolve("new/picture.png");
        String[] all = new String[arguments.length + 3];
        all[0] = "scene";
        System.arraycopy(arguments, 0, all, 1, arguments.length);
        all[arguments.length + 1] = "--out";
        all[arguments.length + 2] = out.toString();
        var answer = Captured.run(all);
        assertEquals(0, answer.exitCode(), answer.err());
        assertEquals("", answer.err());
        return ImageIO.read(out.toFile());
    }

    private static int rgb(BufferedImage picture, int x, int y) {
        return picture.getRGB(x, y) & 0xffffff;
    }

    @Test
    void thePictureIsAsLargeAsTheScenesWindow() throws IOException {
        var picture = picture(scene("a.xml", "box_1_1.3d", 0));
        assertEquals(40, picture.getWidth());
        assertEquals(30, picture.getHeight());
        assertEquals(0xc89600, rgb(picture, 20, 15));
        assertEquals(0, rgb(picture, 0, 0));
    }

    @Test
    void sizeTermsAndWireframeAreObeyed() throws IOException {
        String scene = scene("a.xml", "box_1_1.3d", 0);
        assertEquals(8, picture(scene, "--size", "16x8").getHeight());
        assertEquals(0x003200, rgb(picture(scene, "--light-terms", "emissive"), 20, 15));
        assertEquals(0xc86400, rgb(picture(scene, "--light-terms", "ambient,diffuse"), 20, 15));
        var edges = picture(scene, "--wireframe", "--axes", "--size", "200x200");
        assertEquals(0, rgb(edges, 90, 80), "between edges and diagonal");
        assertEquals(0xff0000, rgb(edges, 5, 100), "the x axis");
    }

    /** The background fills the pixels that the scene leaves empty; the entity rests three units along z. */
    @Test
    void entityAndBackgroundAreShown() throws IOException {
        Path background = folder.resolve("back.png");
        var blue = new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB);
        blue.setRGB(0, 0, 0x000080);
        ImageIO.write(blue, "png", background.toFile());
        String scene = scene("far.xml", "box_1_1.3d", 500);
        String entity = scene("entity.xml", "box_1_1.3d", 0);
        String turned = Files.readString(Path.of(scene))
                .replace("<lookAt x=\"0\" y=\"0\" z=\"0\"/>", "<lookAt x=\"0\" y=\"0\" z=\"9\"/>")
                .replace("z=\"3\"", "z=\"0\"");
        Files.writeString(Path.of(scene), turned);
        var picture = picture(scene, entity, background.toString());
        assertEquals(0xc89600, rgb(picture, 20, 15));
        assertEquals(0x000080, rgb(picture, 1, 1));
    }

    @Test
    void meshesAndTexturesMayLieBesideTheScenesFolder() throws IOException {
        Path scenes = Files.createDirectories(folder.resolve("scenes"));
        Path models = Files.createDirectories(folder.resolve("my models"));
        var box = ShapeKind.BOX.shape(List.of("1", "1")).mesh();
        Files.write(models.resolve("big box.3d"), MeshText.of(box));
        String xml = BOX.replace("MODEL", "..\\my models/big box.3d").replace("SHIFT", "0");
        Path scene = Files.writeString(scenes.resolve("a.xml"), xml);
        assertEquals(0xc89600, rgb(picture(scene.toString()), 20, 15));
    }

    @Test
    void whatIsMissingIsNamedAndTheRestShown() throws IOException {
        String scene = scene("a.xml", "box_1_1.3d\"/><model file=\"ship.3d", 0);
        var answer =
                Captured.run("scene", scene, "--out", folder.resolve("p.png").toString());
        assertEquals(0, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("a.xml:2: ship.3d: there is no such file"), answer.err());
        assertTrue(Files.exists(folder.resolve("p.png")));
    }

    @ParameterizedTest
    @CsvSource({
        "ship.3d, there is no such file",
        "torn.3d, torn.3d:1: \"solid\" is not a number",
        "../torn.3d, there is no such file",
        "../../torn.3d, has a name that is not allowed: it leads out of",
        "/torn.3d, has a name that is not allowed: an asset id neither starts nor ends with '/'",
        "a:b.3d, has a name that is not allowed: character ':' (U+003A)"
    })
    void aSceneOfWhichNothingCanBeShownIsRefused(String model, String said) throws IOException {
        Files.writeString(folder.resolve("torn.3d"), "solid cube\n");
        Path out = folder.resolve("p.png");
        var answer = Captured.run("scene", scene("a.xml", model, 0), "--out", out.toString());
        assertEquals(1, answer.exitCode(), answer.err());
        assertTrue(answer.err().contains("a.xml:2: " + model), answer.err());
        assertTrue(answer.err().contains(said), answer.err());
        assertTrue(answer.err().contains("a.xml:1: none of its models can be shown"), answer.err());
        assertFalse(Files.exists(out), "a picture of nothing");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "SCENE --out p.jpg|2|.png",
                "SCENE --out p.png --time NaN|2|--time",
                "SCENE --out p.png --shading nice|2|'nice' is none of flat, gouraud, phong",
                "SCENE --out p.png --shading wireframe|2|'wireframe' is none of flat, gouraud, phong",
                "SCENE --out p.png --shading flat --wireframe|2|--wireframe",
                "SCENE --out p.png --light-terms red|2|--light-terms",
                "SCENE --out p.png --size 0x5|2|--size",
                "none.xml --out p.png|1|none.xml",
                "BROKEN --out p.png|1|broken.xml:2"
            })
    void mistakesAreNamed(String arguments, int exitCode, String said) throws IOException {
        Path broken = Files.writeString(folder.resolve("broken.xml"), "<world>\n<group");
        String line =
                arguments.replace("SCENE", scene("a.xml", "box_1_1.3d", 0)).replace("BROKEN", broken.toString());
        var answer = Captured.run(("scene " + line).split(" "));
        assertAll(
                () -> assertEquals(exitCode, answer.exitCode(), answer.err()),
                () -> assertTrue(answer.err().contains(said), answer.err()));
    }
}
