package nephele.engine.render;

import java.util.List;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.frame.SharedResource;
import nephele.engine.render.pass.billboard.BillboardPass;
import nephele.engine.render.pass.cloud.CloudDrawing;
import nephele.engine.render.pass.cloud.CloudPass;
import nephele.engine.render.pass.cloud.billboard.BillboardTechnique;
import nephele.engine.render.pass.cloud.particle.ParticleTechnique;
import nephele.engine.render.pass.cloud.procedural.ProceduralTechnique;
import nephele.engine.render.pass.cloud.shade.CloudShadePass;
import nephele.engine.render.pass.cloud.shaft.ShaftPass;
import nephele.engine.render.pass.cloud.skybox.SkyboxTechnique;
import nephele.engine.render.pass.cloud.skyplane.SkyplaneTechnique;
import nephele.engine.render.pass.cloud.volume.VolumeTechnique;
import nephele.engine.render.pass.dynamic.DynamicPass;
import nephele.engine.render.pass.edge.EdgeFilterPass;
import nephele.engine.render.pass.exit.ExitPass;
import nephele.engine.render.pass.exposure.ExposurePass;
import nephele.engine.render.pass.gun.GunPass;
import nephele.engine.render.pass.impostor.ImpostorPass;
import nephele.engine.render.pass.lightning.LightningPass;
import nephele.engine.render.pass.muzzle.MuzzleLightPass;
import nephele.engine.render.pass.particle.ParticlePass;
import nephele.engine.render.pass.portal.OpeningDepthPass;
import nephele.engine.render.pass.portal.PortalPass;
import nephele.engine.render.pass.rim.RimPass;
import nephele.engine.render.pass.rim.UnfilledPass;
import nephele.engine.render.pass.shadow.BakedLightPass;
import nephele.engine.render.pass.shadow.ContactPass;
import nephele.engine.render.pass.shadow.DynamicShadowPass;
import nephele.engine.render.pass.shadow.LightShadowPass;
import nephele.engine.render.pass.shadow.SkyVisibilityPass;
import nephele.engine.render.pass.shadow.SunShadowPass;
import nephele.engine.render.pass.shot.ShotPass;
import nephele.engine.render.pass.sky.AtmospherePass;
import nephele.engine.render.pass.sky.GradientSkyPass;
import nephele.engine.render.pass.sky.SkyboxPass;
import nephele.engine.render.pass.solid.SolidPass;
import nephele.engine.render.pass.temporal.TemporalPass;
import nephele.engine.render.pass.terrain.TerrainPass;
import nephele.engine.render.pass.tonemap.ToneMapPass;
import nephele.engine.render.pass.upscale.UpscalePass;
import nephele.engine.render.resource.AerialPerspective;
import nephele.engine.render.resource.ShaftTables;

/** All features, in frame order: by {@link nephele.engine.render.frame.Stage}, and within each in the listed order. */
public final class RenderFeatures {
    private static final List<CloudDrawing.Technique> CLOUD_TECHNIQUES = List.of(
            VolumeTechnique.REGISTERED,
            SkyplaneTechnique.REGISTERED,
            ProceduralTechnique.REGISTERED,
            BillboardTechnique.REGISTERED,
            ParticleTechnique.REGISTERED,
            SkyboxTechnique.registered(VolumeTechnique.REGISTERED));

    public static final List<RenderFeature> ALL = List.of(
            // Once a frame.
            SunShadowPass.FEATURE,
            LightShadowPass.FEATURE,
            DynamicShadowPass.FEATURE,
            ContactPass.FEATURE,
            SkyVisibilityPass.FEATURE,
            BakedLightPass.FEATURE,
            CloudShadePass.FEATURE,
            // In each view.
            GunPass.FEATURE,
            ShaftPass.FEATURE,
            OpeningDepthPass.FEATURE,
            SolidPass.FEATURE,
            TerrainPass.FEATURE,
            DynamicPass.FEATURE,
            ImpostorPass.FEATURE,
            BillboardPass.FEATURE,
            GradientSkyPass.FEATURE,
            AtmospherePass.FEATURE,
            SkyboxPass.FEATURE,
            RimPass.FEATURE,
            PortalPass.FEATURE,
            UnfilledPass.FEATURE,
            // In each view after its opaque surfaces.
            MuzzleLightPass.FEATURE,
            CloudPass.feature(CLOUD_TECHNIQUES),
            LightningPass.FEATURE,
            BillboardPass.BLENDED,
            ParticlePass.FEATURE,
            ExitPass.FEATURE,
            ExitPass.VEIL,
            ShotPass.FEATURE,
            DynamicPass.HELD,
            GunPass.IN_OPENING,
            // After the views.
            ExposurePass.FEATURE,
            // After everything else.
            ToneMapPass.FEATURE,
            EdgeFilterPass.FEATURE,
            TemporalPass.FEATURE,
            UpscalePass.FEATURE);

    /** Shared resources that shaders of any pass may read, made before the passes. */
    static final List<SharedResource<?>> OF_EVERY_VIEW = List.of(ShaftTables.RESOURCE, AerialPerspective.RESOURCE);

    private RenderFeatures() {}
}
