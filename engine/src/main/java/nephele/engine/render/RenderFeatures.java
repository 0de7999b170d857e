package nephele.engine.render;

import java.util.List;
import nephele.engine.render.frame.RenderFeature;
import nephele.engine.render.pass.portal.OpeningDepthPass;
import nephele.engine.render.pass.portal.PortalPass;
import nephele.engine.render.pass.rim.RimPass;
import nephele.engine.render.pass.rim.UnfilledPass;
import nephele.engine.render.pass.shadow.LampShadowPass;
import nephele.engine.render.pass.shadow.SkyVisibilityPass;
import nephele.engine.render.pass.shadow.SunShadowPass;
import nephele.engine.render.pass.shadow.ThingShadowPass;
import nephele.engine.render.pass.sky.GradientSkyPass;
import nephele.engine.render.pass.sky.SkyboxPass;
import nephele.engine.render.pass.solid.SolidPass;
import nephele.engine.render.pass.thing.ThingPass;
import nephele.engine.render.pass.tonemap.ToneMapPass;

/** Everything that can be drawn, in frame order: by {@link nephele.engine.render.frame.Stage}, and in each as listed. */
public final class RenderFeatures {
    public static final List<RenderFeature> ALL = List.of(
            // Once a frame.
            SunShadowPass.FEATURE,
            LampShadowPass.FEATURE,
            ThingShadowPass.FEATURE,
            SkyVisibilityPass.FEATURE,
            // In each view.
            OpeningDepthPass.FEATURE,
            SolidPass.FEATURE,
            ThingPass.FEATURE,
            GradientSkyPass.FEATURE,
            SkyboxPass.FEATURE,
            RimPass.FEATURE,
            PortalPass.FEATURE,
            UnfilledPass.FEATURE,
            // In each view after its opaque surfaces.
            ThingPass.HELD,
            // After all.
            ToneMapPass.FEATURE);

    private RenderFeatures() {}
}
