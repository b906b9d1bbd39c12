/** Lists of directions, evaluated by the shaders of the maps or by the reference. */
package sunbeam.app.cli.reflectance;
