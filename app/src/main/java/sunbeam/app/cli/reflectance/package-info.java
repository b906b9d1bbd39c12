/** Lists of directions, evaluated by the code that draws the maps or by the exact reference. */
package sunbeam.app.cli.reflectance;
