package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.LightMaps;
import nephele.engine.render.frame.LightMaps.Baked;
import nephele.engine.render.frame.LoadContext;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.gl.BufferTexture;
import nephele.engine.render.gl.GlContext;
import nephele.engine.render.gl.GlObject;
import nephele.engine.render.gl.PixelFormat;
import nephele.engine.render.gl.Sampling;
import nephele.engine.render.gl.SharedObjects.Identity;
import nephele.engine.render.gl.Texture;
import nephele.engine.scene.Scene;
import nephele.engine.scene.light.PackedLight;
import nephele.engine.scene.light.TerrainSky;
import nephele.engine.scene.light.bake.BakedLight;
import nephele.engine.scene.light.bake.IndirectLight;
import nephele.engine.scene.light.bake.LightMapLayout;
import nephele.engine.scene.light.bake.LightSamples;
import nephele.engine.scene.light.bake.SkyVisibility;
import org.lwjgl.system.MemoryUtil;

/**
 * The layers of a level's baked light, added up by their gains, as textures of solids, terrains and models. They are
 * shared by all renderers of the light, and made anew when a gain changes.
 */
public final class SummedLight {
    /** {@code null} without baked light. */
    public static final SharedResource<SummedLight> RESOURCE = SharedResource.of("baked light", SummedLight::of)
            .following((light, frame) -> light.follow(frame.frameState().layerGains()));

    private final Scene scene;
    private final Textures shared;
    /** The light of each vertex of the scene's models; {@code null} without models. */
    private final BufferTexture models;

    private int drawnVersion;

    private SummedLight(LoadContext context) {
        scene = context.scene();
        LightMaps maps = context.request().lightMaps();
        BakedLight light = scene.light();
        var key = new Key(new Identity(light.indirect()), maps.baked(), maps.layers());
        shared = context.share(Textures.class, key, () -> new Textures(context.gl(), light, key));
        boolean isWithoutModels = scene.solids().models().isEmpty();
        models = isWithoutModels ? null : context.own(BufferTexture.changingIntegers(context.gl(), "light of models"));
        uploadModels();
    }

    private static SummedLight of(LoadContext context) {
        return context.request().lightMaps().bakes(Baked.BOUNCED) ? new SummedLight(context) : null;
    }

    private void follow(Map<String, Double> gains) {
        shared.follow(gains);
        if (drawnVersion != shared.version) {
            uploadModels();
        }
    }

    private void uploadModels() {
        drawnVersion = shared.version;
        if (models == null) {
            return;
        }
        int[] known = scene.light().visibility().vertices(scene.solids().drawnModels());
        int[] vertices = scene.solids().modelVertices();
        IntBuffer words = MemoryUtil.memAllocInt(shared.layers * vertices.length);
        for (int vertex : vertices) {
            int number = known == null ? vertex : known[vertex];
            for (int layer = 0; layer < shared.layers; layer++) {
                words.put(
                        number == SkyVisibility.NEW
                                ? shared.ofNew[layer]
                                : shared.vertices.get(layer)[number]);
            }
        }
        models.upload(words.flip());
        MemoryUtil.memFree(words);
    }

    /** Returns the light of static faces, in the texels of the light map: a layer each of radiance, directions, what is mirrored. */
    public Texture texture() {
        return shared.texels;
    }

    /** Returns the light of each vertex of the models, a word for each layer; {@code null} without models. */
    public BufferTexture models() {
        return models;
    }

    /** Returns the light of a terrain at its grid of points; that of new surfaces if it was not baked. */
    public Texture ground(StaticShape.HeightGrid grid) {
        int number = scene.light().groundOf(grid);
        return number == SkyVisibility.NEW ? shared.newGround : shared.grounds.get(number);
    }

    private record Key(Identity light, Set<Baked> baked, int layers) {}

    private static final class Textures implements GlObject {
        private final BakedLight light;
        private final Set<Baked> baked;
        private final int layers;
        private final Texture texels;
        private final List<Texture> grounds = new ArrayList<>();
        /** A texel of what new surfaces look like. */
        private final Texture newGround;

        /** The packed light of all vertices of all models: for each layer of the textures one word a vertex. */
        private List<int[]> vertices;

        private int[] ofNew;
        private Map<String, Double> gains = Map.of();
        private int version;

        private Textures(GlContext gl, BakedLight light, Key key) {
            this.light = light;
            baked = key.baked();
            layers = key.layers();
            LightMapLayout layout = light.layout();
            texels = texture(gl, "baked light", layout.width(), layout.height());
            for (StaticShape.HeightGrid grid : light.statics().ground()) {
                HeightField field = grid.field();
                int columns = TerrainSky.points(field.cellColumns());
                grounds.add(texture(gl, "baked light of a terrain", columns, TerrainSky.points(field.cellRows())));
            }
            newGround = texture(gl, "light of new terrains", 1, 1);
            sum();
        }

        private Texture texture(GlContext gl, String name, int width, int height) {
            var extent = new Texture.Extent(width, height, layers);
            return new Texture(gl, name, Texture.Shape.ARRAY, PixelFormat.RGB9_E5, extent, Sampling.LINEAR_CLAMP);
        }

        private void follow(Map<String, Double> now) {
            if (!now.equals(gains)) {
                gains = now;
                sum();
            }
        }

        private void sum() {
            version++;
            IndirectLight.Layer all = sum(baked.contains(Baked.DIRECT));
            IndirectLight.Layer mirrored = baked.contains(Baked.MIRRORED) ? sum(false) : null;
            List<int[]> solids = words(all, mirrored, IndirectLight.Layer::texels);
            upload(texels, solids);
            vertices = words(all, mirrored, IndirectLight.Layer::vertices);
            for (int i = 0; i < grounds.size(); i++) {
                int ground = i;
                upload(grounds.get(i), words(all, mirrored, sum -> sum.grounds().get(ground)));
            }
            int[] brightest = light.visibility().brightest();
            int texel = brightest[1] * light.layout().width() + brightest[0];
            ofNew = solids.stream().mapToInt(layer -> layer[texel]).toArray();
            upload(
                    newGround,
                    Arrays.stream(ofNew).mapToObj(word -> new int[] {word}).toList());
        }

        private IndirectLight.Layer sum(boolean isDirectBaked) {
            return light.indirect().sum(isDirectBaked, name -> gains.getOrDefault(name, 1.0));
        }

        /** Returns the words of each layer of a texture: radiance, directions if they are drawn, what is mirrored likewise. */
        private List<int[]> words(
                IndirectLight.Layer all,
                IndirectLight.Layer mirrored,
                Function<IndirectLight.Layer, LightSamples> samples) {
            PackedLight packed = PackedLight.of(samples.apply(all));
            List<int[]> words = new ArrayList<>(List.of(packed.radiance()));
            if (baked.contains(Baked.DIRECTIONS)) {
                words.add(packed.direction());
            }
            if (mirrored != null) {
                words.add(PackedLight.of(samples.apply(mirrored)).radiance());
            }
            return words;
        }

        private static void upload(Texture to, List<int[]> words) {
            for (int layer = 0; layer < words.size(); layer++) {
                ByteBuffer bytes = MemoryUtil.memAlloc(Integer.BYTES * words.get(layer).length);
                bytes.asIntBuffer().put(words.get(layer));
                to.upload(layer, bytes);
                MemoryUtil.memFree(bytes);
            }
        }

        @Override
        public void close() {
            texels.close();
            grounds.forEach(Texture::close);
            newGround.close();
        }
    }
}
