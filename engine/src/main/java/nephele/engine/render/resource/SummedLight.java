package nephele.engine.render.resource;

import java.nio.ByteBuffer;
import java.nio.IntBuffer;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.render.frame.LightMaps;
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
        var key = new Key(
                new Identity(light.indirect()),
                maps.bakes(LightMaps.Baked.DIRECT),
                maps.bakes(LightMaps.Baked.DIRECTIONS));
        shared = context.share(Textures.class, key, () -> new Textures(context.gl(), light, key));
        boolean isWithoutModels = scene.solids().models().isEmpty();
        models = isWithoutModels ? null : context.own(BufferTexture.changingIntegers(context.gl(), "light of models"));
        uploadModels();
    }

    private static SummedLight of(LoadContext context) {
        return context.request().lightMaps().bakes(LightMaps.Baked.BOUNCED) ? new SummedLight(context) : null;
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
        IntBuffer words = MemoryUtil.memAllocInt(2 * vertices.length);
        for (int vertex : vertices) {
            int number = known == null ? vertex : known[vertex];
            boolean isNew = number == SkyVisibility.NEW;
            words.put(isNew ? shared.radianceOfNew : shared.vertices.radiance()[number]);
            words.put(isNew ? shared.directionOfNew : shared.vertices.direction()[number]);
        }
        models.upload(words.flip());
        MemoryUtil.memFree(words);
    }

    /** Returns the light of static faces, in the texels of the light map: radiance, then directions if they are drawn. */
    public Texture texture() {
        return shared.texels;
    }

    /** Returns the light of each vertex of the models, two words each; {@code null} without models. */
    public BufferTexture models() {
        return models;
    }

    /** Returns the light of a terrain at its grid of points; that of new surfaces if it was not baked. */
    public Texture ground(StaticShape.HeightGrid grid) {
        int number = scene.light().groundOf(grid);
        return number == SkyVisibility.NEW ? shared.newGround : shared.grounds.get(number);
    }

    private record Key(Identity light, boolean isDirectBaked, boolean hasDirections) {}

    private static final class Textures implements GlObject {
        private final BakedLight light;
        private final boolean isDirectBaked;
        private final boolean hasDirections;
        private final Texture texels;
        private final List<Texture> grounds = new ArrayList<>();
        /** A texel of what new surfaces look like. */
        private final Texture newGround;

        private PackedLight vertices;
        private int radianceOfNew;
        private int directionOfNew;
        private Map<String, Double> gains = Map.of();
        private int version;

        private Textures(GlContext gl, BakedLight light, Key key) {
            this.light = light;
            isDirectBaked = key.isDirectBaked();
            hasDirections = key.hasDirections();
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
            var extent = new Texture.Extent(width, height, hasDirections ? 2 : 1);
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
            IndirectLight.Layer sum = light.indirect().sum(isDirectBaked, name -> gains.getOrDefault(name, 1.0));
            PackedLight packed = PackedLight.of(sum.texels());
            upload(texels, packed);
            vertices = PackedLight.of(sum.vertices());
            List<LightSamples> points = sum.grounds();
            for (int i = 0; i < points.size(); i++) {
                upload(grounds.get(i), PackedLight.of(points.get(i)));
            }
            int[] brightest = light.visibility().brightest();
            int texel = brightest[1] * light.layout().width() + brightest[0];
            radianceOfNew = packed.radiance()[texel];
            directionOfNew = packed.direction()[texel];
            upload(newGround, new PackedLight(new int[] {radianceOfNew}, new int[] {directionOfNew}));
        }

        private void upload(Texture to, PackedLight packed) {
            for (int[] words :
                    hasDirections ? List.of(packed.radiance(), packed.direction()) : List.of(packed.radiance())) {
                ByteBuffer bytes = MemoryUtil.memAlloc(Integer.BYTES * words.length);
                bytes.asIntBuffer().put(words);
                to.upload(words == packed.radiance() ? 0 : 1, bytes);
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
