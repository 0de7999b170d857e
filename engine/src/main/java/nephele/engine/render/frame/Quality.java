package nephele.engine.render.frame;

import java.util.List;
import nephele.engine.cloud.light.BeamLight;
import nephele.engine.cloud.light.CloudOptics;
import nephele.engine.cloud.octave.ProceduralNoise;
import nephele.engine.level.RecordCopy;

/**
 * The settings that trade accuracy for speed. Each is declared once, by its {@link QualitySetting}: values, those of the
 * presets, and what it trades.
 */
public record Quality(
        @QualitySetting(
                        high = "0.75",
                        low = "0.5",
                        medium = "0.7",
                        ultra = "1",
                        least = 0.25,
                        title = "Resolution of the picture",
                        about = "How many pixels are drawn along each side, as a share of the window's; the rest is"
                                + " interpolated, or follows from several frames. Menus, figures and prompts stay"
                                + " sharp.")
                double pictureResolution,
        @QualitySetting(
                        high = "sharp_bilinear",
                        title = "Filter that scales the picture up",
                        about = "Three filters at four shares of the pixels along a side, in five levels of the game,"
                                + " whose frames are drawn one after the other: a filter pays if no other point of"
                                + " the same cost errs less.")
                Upscale upscale,
        @QualitySetting(
                        high = "1",
                        ultra = "8",
                        least = 1,
                        most = 16,
                        title = "Texture anisotropy",
                        about = "How many samples a texture takes along the steep direction of a floor or wall that is"
                                + " seen at a grazing angle. One sample blurs the far end of floors.")
                int anisotropy,
        @QualitySetting(
                        high = "on",
                        title = "Normal maps",
                        about = "Relief smaller than a triangle: joints, grain and ripples change the light. Without"
                                + " it surfaces are as smooth as their geometry.")
                NormalMaps normalMaps,
        @QualitySetting(
                        high = "ggx",
                        title = "Reflection of surfaces",
                        about = "GGX gives each roughness its highlight. Lambert reflects all light diffusely: nothing"
                                + " shines, and metal looks like paint.")
                ReflectionModel brdf,
        @QualitySetting(
                        high = "4096",
                        low = "2048",
                        least = 64,
                        most = 16384,
                        title = "Sun shadow",
                        about = "The sun's shadows come from a depth map of this many texels along its longer side,"
                                + " but of no finer texels than 1 cm. Off means that neither sun nor punctual"
                                + " lights cast any.")
                int shadowTexels,
        @QualitySetting(
                        high = "bilinear",
                        title = "Filter of shadow maps",
                        about = "Whether one texel of a shadow map decides the light of a point, or the four around"
                                + " it, weighted. One gives shadows with steps.")
                ShadowSampling shadowFilter,
        @QualitySetting(
                        high = "live",
                        low = "baked",
                        title = "Light straight from sun and lamps",
                        about = "Where a level's light was baked, walls take that of sun and lamps from the bake too:"
                                + " a texture instead of shadow maps, with shadows as soft as its texels and none of"
                                + " what moves. Without a bake it is always live.")
                DirectLight directLight,
        @QualitySetting(
                        high = "on",
                        low = "off",
                        title = "Directions of baked light",
                        about = "Baked light comes from somewhere, so that it shows relief and is reflected. Without"
                                + " its directions normal maps are flat where no sun or lamp shines.")
                LightDirections lightDirections,
        @QualitySetting(
                        high = "999",
                        most = Quality.ALL_LIGHTS,
                        title = "Lamps with shadows",
                        about = "So many lamps cast shadows at most, the most powerful ones. The light of the others"
                                + " goes through walls.")
                int lightShadows,
        @QualitySetting(
                        high = "on",
                        low = "off",
                        title = "Contact shadows",
                        about = "Where light is baked, bodies and the character hide some of it from what is near them."
                                + " Without it they seem to float in shade.")
                Contact contact,
        @QualitySetting(
                        high = "1",
                        ultra = "4",
                        least = 1,
                        most = 8,
                        title = "Samples a pixel",
                        about = "Edges of walls, portals and dynamic objects are smoothed by testing coverage at"
                                + " several points of a pixel (multisampling). One point gives stairs.")
                int samples,
        @QualitySetting(
                        high = "temporal",
                        low = "none",
                        medium = "none",
                        ultra = "none",
                        title = "Antialiasing",
                        about = "How edges are smoothed beside samples: each frame sees other points of a pixel, and"
                                + " the frames are averaged, also to more pixels than one frame draws; or stairs"
                                + " are smoothed in the displayed picture, by the edges' shapes, where detail"
                                + " smaller than a pixel is lost. With several samples a pixel frames are not"
                                + " averaged.")
                Antialiasing antialiasing,
        @QualitySetting(
                        high = "stencil",
                        title = "How portals are drawn",
                        about = "What is behind a portal is drawn straight into the picture where a stencil allows it,"
                                + " or into a texture that then covers the opening. The source also weighed to"
                                + " draw it into the frame buffer, to copy that out and to draw the rest over it;"
                                + " copying only the opening's part is the last setting.")
                PortalTechnique portalTechnique,
        @QualitySetting(
                        high = "12",
                        low = "6",
                        medium = "9",
                        ultra = "32",
                        most = 9999,
                        title = "Views through portals",
                        about = "So many views through portals are drawn in a frame at most, the largest ones. In"
                                + " openings beyond the budget the previous picture is shown, moved to where it"
                                + " fits; before there is one, the sky there behind the portal's membrane.")
                int viewBudget,
        @QualitySetting(
                        high = "1",
                        least = 0.1,
                        title = "Resolution of portal pictures",
                        about = "Of the texture technique: how many pixels a portal's picture has along each side, as"
                                + " a share of the whole picture's. Stencil is shown beside it; it has no such"
                                + " knob.")
                double portalResolution,
        @QualitySetting(
                        high = "0.5",
                        ultra = "1",
                        least = 0.125,
                        title = "Rays through clouds",
                        about = "How many rays are marched along each side of the picture. Fewer are interpolated;"
                                + " in front of surfaces there are half as many, but each pixel of an edge sees what"
                                + " is in front of its own surface.")
                double cloudResolution,
        @QualitySetting(
                        high = "four_frames",
                        low = "sixteen_frames",
                        medium = "sixteen_frames",
                        ultra = "none",
                        title = "Rays through clouds among frames",
                        about = "A frame marches one ray of each square of rays; the others show what earlier frames"
                                + " have seen in their direction. A still view loses nothing, a moving one some"
                                + " sharpness.")
                CloudHistory cloudHistory,
        @QualitySetting(
                        high = "1",
                        low = "2",
                        least = 0.25,
                        most = 16,
                        title = "Steps through clouds",
                        about = "How far apart the samples of a ray through a cloud are, in its cells. Long steps miss"
                                + " thin parts.")
                double cloudStep,
        @QualitySetting(
                        high = "2",
                        least = 1,
                        most = 8,
                        title = "Map of the light in clouds",
                        about = "The optical depth towards the sun and the diffuse light are found once for each cell"
                                + " of a map, whose edge this is, in cells of density. Small cells take longer to"
                                + " make and more memory, and show shadows of smaller lobes; a frame reads one of"
                                + " either size as fast.")
                int cloudLightCell,
        @QualitySetting(
                        high = "two_stream",
                        title = "Light scattered often in clouds",
                        about = "Most light of a thick cloud has been scattered tens of times. The two-stream model"
                                + " finds it in closed form from the optical depths around each point, and follows"
                                + " small angles along the path; octaves repeat single scattering with less"
                                + " extinction and lose most of it.")
                CloudScattering cloudScattering,
        @QualitySetting(
                        high = "viewer",
                        title = "Turning of flat clouds",
                        about = "Clouds of technique billboard are flat pictures of balls. Turned towards the eye they"
                                + " are the balls as far away; turned as the screen they grow towards the"
                                + " picture's edges; turned about an upright axis they are thin from above and"
                                + " below.")
                BillboardFacing billboardFacing,
        @QualitySetting(
                        high = "tail",
                        title = "Sunlight in clouds of balls",
                        about = "The tail is the two-stream model, with all light that is scattered often. Dobashi's"
                                + " model of 2000 has light that is scattered once; Harris' of 2001 also light"
                                + " that was scattered forwards before, here so that it does not depend on the"
                                + " number of balls. Both lose what leaves the beam.")
                PuffLight particleLight,
        @QualitySetting(
                        high = "auto",
                        ultra = "off",
                        title = "Impostors of clouds of balls",
                        about = "A cloud of soft balls far away is drawn once and shown from that picture until the"
                                + " eye has moved so far that a part of it would be in a wrong place. Pictures are"
                                + " made over several frames; clouds that are near are drawn ball by ball.")
                ImpostorChoice impostors,
        @QualitySetting(
                        high = "1",
                        least = 0.1,
                        most = 16,
                        title = "Error of impostors",
                        about = "How many pixels a part of a cloud may be from its place before its picture is"
                                + " replaced. A smaller error takes more pictures, or drawing ball by ball if the"
                                + " eye is fast.")
                double impostorErrorPixels,
        @QualitySetting(
                        high = "shell",
                        title = "Shape of sheets of cloud",
                        about = "A layer that is drawn as a sheet bends around the planet as layers do. A plane, a"
                                + " mesh that sinks too fast and a hemisphere show its clouds in other"
                                + " directions.")
                SkyplaneShape skyplaneShape,
        @QualitySetting(
                        high = "smooth",
                        title = "Noise of procedural clouds",
                        about = "Octaves of gradient noise have no period and change smoothly. Three pictures of white"
                                + " noise that are enlarged and cross-faded repeat, and pulse while they fade. The"
                                + " skies are other ones of the same cover: the error says how different they are,"
                                + " not which one is wrong.")
                ProceduralNoise proceduralNoise,
        @QualitySetting(
                        high = "512",
                        least = 16,
                        most = 4096,
                        title = "Texels of clouds as skyboxes",
                        about = "A cloud of technique skybox is drawn into pictures around one point when a level is"
                                + " loaded, and looked up afterwards. Fewer texels along a face of 90° make it"
                                + " soft; a frame costs the same.")
                int cloudSkyboxTexels,
        @QualitySetting(
                        high = "lod",
                        title = "Triangles of terrains",
                        about = "All triangles of the height map, or as many as the picture needs: tiles of coarser"
                                + " triangles, chosen for each view, whose error stays below terrainErrorPixels."
                                + " Light is that of all samples.")
                TerrainDetail terrainDetail,
        @QualitySetting(
                        high = "1",
                        low = "4",
                        least = 0.1,
                        most = 64,
                        title = "Error of terrains",
                        about = "How many drawn pixels coarser triangles may show a point of the ground from its"
                                + " place.")
                double terrainErrorPixels,
        @QualitySetting(
                        high = "mixed",
                        title = "Layers of terrains",
                        about = "Layers of materials are mixed at each pixel, or once into a picture of the whole"
                                + " terrain, as a source of 2010 did: then near ground is blurred and cliffs"
                                + " stretch it.")
                LayerMixing terrainLayers,
        @QualitySetting(
                        high = "all",
                        title = "Parts of light",
                        about = "Ambient, diffuse and specular light of surfaces, each alone and all together, as a"
                                + " source of 2010 showed them.")
                LightParts lightParts,
        @QualitySetting(
                        high = "64",
                        most = 256,
                        title = "Impostors of models",
                        about = "How many pixels a model has where its impostor takes the place of its mesh; 0 draws"
                                + " meshes alone. An impostor is a rectangle with pictures of the model from three"
                                + " directions, lit as the mesh is.")
                double impostorPixels,
        @QualitySetting(
                        high = "kept",
                        title = "Mipmaps of billboards",
                        about = "Smaller mipmap levels keep the share of the picture that is drawn, or the mean of"
                                + " alpha, with which crowns and grass become thin far away.")
                SpriteCoverage spriteCoverage,
        @QualitySetting(
                        high = "0.5",
                        low = "1",
                        least = 0.125,
                        most = 8,
                        title = "Spacing of light probes",
                        about = "Where light was baked, moving things are lit by their surroundings as seen from the"
                                + " points of a lattice with this spacing, in metres. Between far ones light near"
                                + " lamps and corners is blurred; they are found less often while one walks.")
                double probeMetres) {
    /** Enough for every light that can have a shadow. */
    public static final int ALL_LIGHTS = 999;

    /** All settings, in the order of declaration. */
    public static final List<QualityField> FIELDS = QualityField.of(Quality.class);

    public static final Quality LOW = preset(Preset.LOW);
    public static final Quality MEDIUM = preset(Preset.MEDIUM);
    public static final Quality HIGH = preset(Preset.HIGH);
    public static final Quality ULTRA = preset(Preset.ULTRA);

    /** The presets, the cheapest first. */
    public enum Preset {
        LOW,
        MEDIUM,
        HIGH,
        ULTRA
    }

    /** Decides whether moving objects darken the ambient light of what is near them. */
    public enum Contact {
        OFF,
        ON
    }

    /** The source of the light straight from sun and lamps on static surfaces. */
    public enum DirectLight {
        LIVE,
        /** The bake, if there is one; a sun that moves stays live, one that does not shines through the clouds of the first moment. */
        BAKED
    }

    /** Whether baked light has directions. */
    public enum LightDirections {
        OFF,
        ON
    }

    /** The way in which edges of the displayed picture are smoothed. */
    public enum Antialiasing {
        NONE,
        /** Coverage is estimated from the shapes of edges. */
        MORPHOLOGICAL,
        /** Frames see different points of each pixel and are averaged; only with one sample a pixel. */
        TEMPORAL
    }

    /** How many frames share the rays of a view through clouds; a ray that was not marched now shows an earlier frame. */
    public enum CloudHistory {
        NONE(1),
        FOUR_FRAMES(2),
        SIXTEEN_FRAMES(4);

        private final int side;

        CloudHistory(int side) {
            this.side = side;
        }

        /** Returns the side of the square of rays of which a frame marches one. */
        public int side() {
            return side;
        }
    }

    /** The model of light that clouds scatter more than once. */
    public enum CloudScattering {
        /** {@link nephele.engine.cloud.light.CloudLight}: two streams of diffuse light, small angles along the path. */
        TWO_STREAM,
        /**
         * Eight times single scattering, each with half the light, optical depth and asymmetry of the one before
         * (Wrenninge 2013); the sum is far too dark in thick clouds.
         */
        OCTAVES
    }

    /** How the flat pictures of clouds of technique billboard are turned; shaders know the order. */
    public enum BillboardFacing {
        /** As the screen. */
        SCREEN,
        /** Towards the eye. */
        VIEWER,
        /** Towards the eye about an upright axis. */
        AXIAL,
        /** By the formula of a source of 2004, which is wrong beside the axes and undefined on them. */
        SOURCE
    }

    /** Decides which clouds of balls are drawn from pictures of them. */
    public enum ImpostorChoice {
        OFF,
        /** Impostors for balls whose pictures stay valid long enough to repay drawing them. */
        AUTO
    }

    /** The triangles of which terrains are drawn. */
    public enum TerrainDetail {
        /** All of the height map. */
        FULL,
        /** {@link nephele.engine.math.heightfield.DetailRanges}: fewer where the picture shows no difference. */
        LOD
    }

    /** Where the layers of a terrain are mixed. */
    public enum LayerMixing {
        /** At each pixel, in the pictures' own resolution, with normal maps. */
        MIXED,
        /** Once, seen from above, into one picture for the whole terrain, as in a source of 2010. */
        BAKED
    }

    /** What smaller mipmap levels of billboards with edges keep. */
    public enum SpriteCoverage {
        /** The share of the picture that is drawn, see {@link nephele.engine.level.billboard.AlphaCoverage}. */
        KEPT,
        /** The mean of alpha: crowns become thin far away. */
        MEAN
    }

    /** The parts of the light that surfaces reflect; what glows shows always. */
    public enum LightParts {
        ALL,
        /** Light of the sky, or the ambient constant of the level. */
        AMBIENT,
        /** Light of sun, lamps and lightning that is reflected diffusely. */
        DIFFUSE,
        /** Light of sun, lamps and lightning that the specular lobe reflects. */
        SPECULAR
    }

    /** The filter that scales a picture up. */
    public enum Upscale {
        /** The four nearest pixels by their distances. */
        BILINEAR,
        /** The four nearest pixels with steeper weights: as cheap, and nearer to the whole picture. */
        SHARP_BILINEAR,
        /** Twelve pixels, weighted along the edges between them. */
        EDGE_ADAPTIVE
    }

    /** Decides whether normal maps are read. */
    public enum NormalMaps {
        ON,
        OFF
    }

    /** The reflection of light by a surface. */
    public enum ReflectionModel {
        /** All light is reflected diffusely, also by metal; nothing shines. */
        LAMBERT,
        /** {@link nephele.engine.level.appearance.Brdf}. */
        GGX
    }

    /** The texels of a shadow map that decide the light of a point. */
    public enum ShadowSampling {
        /** The one that contains it: edges with steps. */
        NEAREST,
        /** The four around it, weighted. */
        BILINEAR
    }

    /**
     * Returns the preset as a graphics card draws it, where pixels, samples, anisotropy and filters cost little: all pixels
     * from high on, 2, 4, 4 and 8 samples a pixel in place of other antialiasing, anisotropy 2, 4, 8 and 16.
     */
    public Quality onHardware() {
        if (equals(LOW)) {
            return onHardware(0.5, 2, 2);
        } else if (equals(MEDIUM)) {
            return onHardware(0.7, 4, 4);
        } else if (equals(HIGH)) {
            return onHardware(1, 4, 8);
        }
        return equals(ULTRA) ? onHardware(1, 8, 16) : this;
    }

    private Quality onHardware(double resolution, int itsSamples, int itsAnisotropy) {
        return with("pictureResolution", resolution)
                .with("antialiasing", Antialiasing.NONE)
                .with("samples", itsSamples)
                .with("anisotropy", itsAnisotropy)
                .with("upscale", Upscale.EDGE_ADAPTIVE);
    }

    /** Returns the quality of single frames that show what this one shows in several. */
    public Quality inOneFrame() {
        return antialiasing == Antialiasing.TEMPORAL
                ? with("antialiasing", Antialiasing.NONE).with("pictureResolution", 1.0)
                : this;
    }

    private static Quality preset(Preset preset) {
        return QualityField.record(Quality.class, FIELDS, preset);
    }

    /**
     * Returns this quality with another value of one setting.
     *
     * @param setting its name
     * @param value of its type
     * @throws IllegalArgumentException if there is no such setting, or it is of another type
     */
    public Quality with(String setting, Object value) {
        return RecordCopy.with(this, setting, value);
    }

    /** The shape of the sheet as which a layer of clouds is drawn. */
    public enum SkyplaneShape {
        /** A sphere around the planet under an atmosphere, otherwise a plane. */
        SHELL,
        FLAT,
        /**
         * A mesh of 17 × 17 vertices around the eye that sinks by the square of the distance, 2√(R₂² − R₁²) wide and R₁
         * above the eye, with R₂ = 9 R₁.
         */
        CURVED,
        /** A hemisphere around the eye. */
        DOME
    }

    /** The model of sunlight in clouds that are drawn as soft balls. */
    public enum PuffLight {
        /** {@link CloudLight}, as in clouds that are marched: what is scattered often is found too. */
        TAIL,
        /**
         * Light that is scattered once (Dobashi, Kaneda, Yamashita, Okita and Nishita 2000, "A Simple, Efficient Method for Realistic
         * Animation of Clouds").
         */
        DOBASHI,
        /** Light that is scattered towards the eye once, and before that any number of times forwards: {@link BeamLight#forwards}. */
        HARRIS;

        /** Returns the light that is accumulated along the beam; {@code null} for the tail, which has more. */
        public BeamLight beam(CloudOptics optics) {
            return switch (this) {
                case TAIL -> null;
                case DOBASHI -> BeamLight.once(optics);
                case HARRIS -> BeamLight.forwards(optics);
            };
        }
    }
}
