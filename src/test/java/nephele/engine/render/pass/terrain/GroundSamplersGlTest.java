package nephele.engine.render.pass.terrain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.lwjgl.opengl.GL41C.*;

import java.nio.IntBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.TreeSet;
import nephele.engine.asset.LayerMap;
import nephele.engine.asset.TestAssets;
import nephele.engine.choice.LevelRenderer;
import nephele.engine.level.Level;
import nephele.engine.level.TestTerrain;
import nephele.engine.level.json.LevelJson;
import nephele.engine.level.placed.PlacedLevel;
import nephele.engine.math.Vec3;
import nephele.engine.render.Offscreen;
import nephele.engine.render.RenderSettings;
import nephele.engine.render.Renderer;
import nephele.engine.render.frame.Output;
import nephele.engine.render.frame.Quality;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.FormulaLight;
import nephele.engine.scene.light.bake.IndirectLight;
import org.junit.jupiter.api.Test;
import org.lwjgl.system.MemoryStack;

/** A terrain with everything that its program can read stays within the sixteen samplers that OpenGL 4.1 guarantees for a shader. */
class GroundSamplersGlTest {
    private static final String EVERYTHING =
            """
            {"format": "nephele-level", "version": 1,
            "environment": {"sun": {"directionTowardsSun": [0.3, 0.8, 0.2], "irradiance": [3, 3, 3]},
            "sky": {"kind": "atmosphere"}, "exposureStops": "auto",
            "clouds": [{"id": "c", "kind": "volume", "centre": [0, 150, -100], "size": [200, 100, 100],
            "density": {"kind": "ellipsoid"}, "extinctionPerMetre": 0.05, "shafts": true}]},
            "lights": [{"id": "l", "kind": "spot", "position": [0, 30, 0], "direction": [0, -1, 0.1],
            "radiantIntensity": [90, 90, 90], "rangeMetres": 60}%s],
            "materials": [{"id": "a", "texture": "a.png", "normalTexture": "n.png", "roughness": 0.5, "metallic": 0.1},
            {"id": "b"}],
            "bodies": [{"id": "cube", "kind": "box", "centre": [0, 20, 0], "size": [1, 1, 1], "massKilograms": 1}],
            "terrains": [{"id": "t", "heightMap": "map.r16", "centre": [0, 0, 0], "sizeMetres": [64, 64],
            "heightRangeMetres": [0, 10], "layerMap": "layers.png",
            "layers": [{"material": "a", "toMetres": 5}, {"material": "b", "fromMetres": 5}]}]}
            """;

    /** Lights so many that each pixel looks up those near it. */
    private static String lamps() {
        StringBuilder lamps = new StringBuilder();
        for (int i = 0; i < 64; i++) {
            lamps.append(", {\"id\": \"p%d\", \"kind\": \"point\", \"position\": [%d, 12, %d], "
                    .formatted(i, 4 * (i % 8), i));
            lamps.append("\"radiantIntensity\": [1, 1, 1], \"rangeMetres\": 5, \"castsShadow\": false}");
        }
        return lamps.toString();
    }

    private static TestAssets assets() {
        return TestTerrain.map(33, TestTerrain::wavy)
                .picture("a.png", 4, 4, (x, y) -> 0x808080)
                .picture("n.png", 4, 4, (x, y) -> 0x8080ff)
                .file("layers.png", LayerMap.blank(4, 4).png());
    }

    /** Returns the names of the samplers of the program that reads a layer map. */
    private static Set<String> samplers() {
        Set<String> names = new TreeSet<>();
        for (int program = 1; program < 400; program++) {
            if (!glIsProgram(program) || glGetUniformLocation(program, "layerMap") < 0) {
                continue;
            }
            try (MemoryStack stack = MemoryStack.stackPush()) {
                IntBuffer size = stack.mallocInt(1);
                IntBuffer type = stack.mallocInt(1);
                for (int i = 0; i < glGetProgrami(program, GL_ACTIVE_UNIFORMS); i++) {
                    String name = glGetActiveUniform(program, i, size, type);
                    if (isSampler(type.get(0))) {
                        assertEquals(1, size.get(0), name);
                        names.add(name);
                    }
                }
            }
        }
        return names;
    }

    private static boolean isSampler(int type) {
        return switch (type) {
            case GL_SAMPLER_2D,
                    GL_SAMPLER_3D,
                    GL_SAMPLER_CUBE,
                    GL_SAMPLER_2D_ARRAY,
                    GL_SAMPLER_2D_SHADOW,
                    GL_SAMPLER_2D_ARRAY_SHADOW,
                    GL_SAMPLER_BUFFER,
                    GL_INT_SAMPLER_BUFFER,
                    GL_UNSIGNED_INT_SAMPLER_2D,
                    GL_UNSIGNED_INT_SAMPLER_3D,
                    GL_UNSIGNED_INT_SAMPLER_BUFFER -> true;
            default -> false;
        };
    }

    /** A seventeenth is read by vertices alone. */
    @Test
    void bakedLightIsOneMoreBesideTheTilesOfVertices() {
        Level level =
                LevelJson.read("everything.json", EVERYTHING.formatted(lamps()).getBytes(StandardCharsets.UTF_8));
        PlacedLevel placed = PlacedLevel.of(level, assets());
        BakedLight light = new FormulaLight(placed.statics())
                .layer("", IndirectLight.Course.INDIRECT, place -> new Vec3(1, 1, 1), new Vec3(0, 0.5, 0))
                .baked(IndirectLight.SkyLight.LIVE);
        try (Offscreen offscreen = new Offscreen(32, 32);
                Renderer renderer = LevelRenderer.load(
                        offscreen.gl, Scene.of(placed, light), RenderSettings.of(Output.HDR, Quality.ULTRA))) {
            renderer.draw(offscreen.view(new Vec3(0, 22, 13), new Vec3(0, 5, -5)), offscreen.picture);
            Set<String> samplers = samplers();
            assertEquals(17, samplers.size(), samplers::toString);
            assertTrue(samplers.containsAll(Set.of("bakedLight", "terrainSky", "terrainTiles")), samplers::toString);
        }
    }

    @Test
    void allThatAGroundCanReadIsSixteenTextures() {
        Level level =
                LevelJson.read("everything.json", EVERYTHING.formatted(lamps()).getBytes(StandardCharsets.UTF_8));
        try (Offscreen offscreen = new Offscreen(32, 32)) {
            offscreen.pixels(
                    level,
                    assets(),
                    offscreen.view(new Vec3(0, 22, 13), new Vec3(0, 5, -5)),
                    RenderSettings.of(Output.HDR, Quality.ULTRA));
            Set<String> samplers = samplers();
            assertEquals(16, samplers.size(), samplers::toString);
        }
    }
}
