package nephele.engine.scene;

import nephele.engine.portal.Portal;

/**
 * Where a shot would open a portal.
 *
 * @param colour 0 or 1, the shot
 */
public record Ghost(Portal portal, int colour) {}
