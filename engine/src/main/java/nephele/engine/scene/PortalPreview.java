package nephele.engine.scene;

import nephele.engine.portal.Portal;

/**
 * The preview of the portal that a shot would open.
 *
 * @param colour 0 or 1, the number of the shot
 */
public record PortalPreview(Portal portal, int colour) {}
